#include "pliant/measurement/column_synonyms.h"

namespace pliant {

const std::map<std::string, std::vector<std::string>>& column_synonyms() {
  static const std::map<std::string, std::vector<std::string>> synonyms{
      {"force",
       {"load", "standard force", "tensile force", "shear force", "axial force", "test force",
        "load cell", "tension", "Kraft", "Standardkraft", "Prüfkraft", "Pruefkraft", "Zugkraft",
        "Schubkraft", "Fs"}},
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
        "Weg"}},
      {"length", {"grip separation", "clamp distance", "Länge", "Laenge"}},
      {"strain",
       {"tensile strain", "engineering strain", "stroke strain", "elongation", "extension",
        "Dehnung", "Standarddehnung"}},
      {"time", {"test time", "elapsed time", "Zeit", "Prüfzeit", "Pruefzeit"}},
      {"angle", {"shear angle", "Scherwinkel", "Winkel"}},
      {"curvature", {"Krümmung", "Kruemmung", "K"}},
      {"moment", {"bending moment", "Moment", "Biegemoment", "M"}},
      {"weight", {"Gewicht"}}};
  return synonyms;
}

}  // namespace pliant
