#include "pliant/measurement/column_synonyms.h"

namespace pliant {

const std::map<std::string, std::vector<std::string>>& column_synonyms() {
  static const std::map<std::string, std::vector<std::string>> synonyms{
      {"force",
       {"load", "standard force", "tensile force", "axial force", "shear force", "Kraft",
        "Standardkraft", "Prüfkraft", "Pruefkraft", "Zugkraft"}},
      {"extension",
       {"tensile extension", "elongation", "displacement", "tensile displacement",
        "axial displacement", "standard travel", "position", "stroke", "crosshead",
        "crosshead travel", "Verlängerung", "Verlaengerung", "Längenänderung", "Laengenaenderung",
        "Standardweg", "Traversenweg", "Weg"}},
      {"length", {"grip separation", "clamp distance", "Länge", "Laenge"}},
      {"strain",
       {"tensile strain", "engineering strain", "elongation", "extension", "Dehnung",
        "Standarddehnung"}},
      {"time", {"test time", "elapsed time", "Zeit", "Prüfzeit", "Pruefzeit"}},
      {"angle", {"shear angle", "Scherwinkel", "Winkel"}},
      {"curvature", {"Krümmung", "Kruemmung"}},
      {"moment", {"bending moment", "Moment", "Biegemoment"}},
      {"weight", {"Gewicht"}}};
  return synonyms;
}

}  // namespace pliant
