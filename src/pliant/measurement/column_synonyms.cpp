#include "pliant/measurement/column_synonyms.h"

namespace pliant {

const std::map<std::string, std::vector<std::string>>& column_synonyms() {
  static const std::map<std::string, std::vector<std::string>> synonyms{
      {"force", {"load",       "standard force", "tensile force", "shear force", "axial force",
                 "test force", "load cell",      "tension",       "Kraft",       "Standardkraft",
                 "Prüfkraft",  "Pruefkraft",     "Zugkraft",      "Schubkraft",  "Fs",
                 "力",         "力值",           "试验力",        "拉力",        "负荷",
                 "载荷"}},
      {"extension",
       {"tensile extension",
        "elongation",
        "displacement",
        "tensile displacement",
        "standard travel",
        "stroke",
        "crosshead",
        "crosshead travel",
        "crosshead position",
        "axial displacement",
        "position",
        "ext",
        "ext.",
        "Verlängerung",
        "Verlaengerung",
        "Längenänderung",
        "Laengenaenderung",
        "Standardweg",
        "Traversenweg",
        "Weg",
        "位移",
        "变形",
        "伸长"}},
      {"length", {"grip separation", "clamp distance", "Länge", "Laenge"}},
      {"strain",
       {"tensile strain", "engineering strain", "stroke strain", "elongation", "extension",
        "Dehnung", "Standarddehnung", "应变", "伸长率"}},
      {"time", {"test time", "elapsed time", "Zeit", "Prüfzeit", "Pruefzeit", "时间"}},
      {"angle", {"shear angle", "Scherwinkel", "Winkel"}},
      {"curvature", {"Krümmung", "Kruemmung", "K"}},
      {"moment", {"bending moment", "Moment", "Biegemoment", "M"}},
      {"weight", {"Gewicht"}}};
  return synonyms;
}

}  // namespace pliant
