#include "pliant/exchange/febio_file.h"

#include <map>
#include <set>

#include <Eigen/LU>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/geometry/volume_regions.h"
#include "pliant/io/xml_text.h"

namespace pliant {
namespace {

constexpr std::size_t kMostOgdenTerms = 6, kLongestName = 80;
constexpr const char* kTetrahedra = "tetrahedra";
constexpr const char* kHexahedra = "hexahedra";

/// A law: the type of the material and its numbers.
struct FebioLaw {
  std::string type;
  std::vector<std::pair<std::string, std::string>> parameters;

  void add(const std::string& name, double value) {
    parameters.emplace_back(name, format_number(value));
  }
};

class LawWriter {
 public:
  explicit LawWriter(const SolidToConvert& solid) : solid_(solid) {}

  FebioLaw law() {
    return std::visit([this](const auto& shape) { return law_of(shape); }, solid_.law.shape);
  }
  std::vector<std::string>& lost() { return lost_; }

 private:
  FebioLaw law_of(const StvkLaw& law) {
    FebioLaw febio{"isotropic elastic", {}};
    febio.add("E", law.young());
    febio.add("v", law.poisson());
    return febio;
  }

  FebioLaw law_of(const OrthotropicStvkLaw& law) {
    const Eigen::Matrix3d compliance = law.normal.inverse();
    FebioLaw febio{"orthotropic elastic", {}};
    for (int a = 0; a < 3; ++a) febio.add(fmt::format("E{}", a + 1), 1 / compliance(a, a));
    febio.add("G12", law.shear(2));
    febio.add("G23", law.shear(0));
    febio.add("G31", law.shear(1));
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      febio.add(fmt::format("v{}{}", a + 1, b + 1), -compliance(a, b) / compliance(a, a));
    }
    return febio;
  }

  FebioLaw law_of(const InvariantLaw& law) {
    if (law.second == 0 && (law.first[1] != 0 || law.first[2] != 0)) return powers(law.first);
    if (law.first[1] != 0 || law.first[2] != 0) {
      refuse("components.I2-bar", "beside powers of I1-bar");
    }
    if (law.first[0] <= 0) refuse("components.I1-bar", "with a c1 of Mooney-Rivlin not above 0");
    FebioLaw febio = uncoupled("Mooney-Rivlin");
    febio.add("c1", law.first[0]);
    febio.add("c2", law.second);
    return febio;
  }

  FebioLaw law_of(const ArrudaBoyceLaw& law) { return powers(powers_of(law)); }

  FebioLaw law_of(const OgdenLaw& law) {
    if (law.terms.size() > kMostOgdenTerms) {
      refuse(law.isochoric ? "components.stretch-bar" : "components.stretch",
             fmt::format("of {} powers: {} at most", law.terms.size(), kMostOgdenTerms));
    }
    FebioLaw febio = law.isochoric ? uncoupled("Ogden") : FebioLaw{"Ogden unconstrained", {}};
    for (std::size_t i = 0; i < law.terms.size(); ++i) {
      febio.add(fmt::format("c{}", i + 1), 2 * law.terms[i].mu);
      febio.add(fmt::format("m{}", i + 1), law.terms[i].alpha);
    }
    if (law.isochoric) return febio;
    const VolumeEnergy& volume = solid_.law.volume;
    if (volume.form != VolumeEnergy::Form::of_ratio && volume.form != VolumeEnergy::Form::none) {
      lost_of_form();
    }
    febio.add("cp", volume.bulk);
    return febio;
  }

  FebioLaw law_of(const CoupledMooneyRivlinLaw& law) {
    if (law.first <= 0) refuse("components.I1", "with a c1 of Mooney-Rivlin not above 0");
    FebioLaw febio{"coupled Mooney-Rivlin", {}};
    febio.add("c1", law.first);
    febio.add("c2", law.second);
    febio.add("k", solid_.law.volume.bulk);
    return febio;
  }

  template <std::size_t Count>
  FebioLaw powers(const std::array<double, Count>& coefficients) {
    FebioLaw febio = uncoupled("Yeoh");
    for (std::size_t i = 0; i < Count; ++i) febio.add(fmt::format("c{}", i + 1), coefficients[i]);
    return febio;
  }

  /// A law of what keeps its volume, with what resists a change of volume.
  FebioLaw uncoupled(const std::string& type) {
    FebioLaw febio{type, {}};
    double bulk = solid_.law.volume.bulk;
    const VolumeEnergy::Form form = solid_.law.volume.form;
    if (form == VolumeEnergy::Form::none) {
      bulk = kFebioBulk * shear_modulus(solid_.law);
      lost_.push_back(fmt::format(
          "the constant volume: a bulk modulus k of {} times the shear modulus ({} Pa) stands for "
          "it",
          kFebioBulk, format_number(bulk, 4)));
    }
    if (form == VolumeEnergy::Form::something) lost_of_form();
    febio.add("k", bulk);
    febio.parameters.emplace_back("pressure_model", pressure_model(form));
    return febio;
  }

  static const char* pressure_model(VolumeEnergy::Form form) {
    if (form == VolumeEnergy::Form::of_log) return "default";
    return form == VolumeEnergy::Form::of_square ? "NIKE3D" : "Abaqus";
  }

  void lost_of_form() {
    lost_.emplace_back(
        "the form of the volume's energy: written as bulk / 2 (J - 1)^2, the same to second order "
        "in J - 1");
  }

  [[noreturn]] void refuse(const std::string& field, const std::string& what) const {
    throw InputError({solid_.file, 0, field},
                     fmt::format("is a law {}, which FEBio does not have", what), "another law");
  }

  const SolidToConvert& solid_;
  std::vector<std::string> lost_;
};

std::string name_text(const std::string& name) { return xml_text(one_line(name, kLongestName)); }

std::string material_text(const SolidToConvert& solid, const FebioLaw& law) {
  std::string text = fmt::format("  <Material>\n    <material id=\"1\" name=\"{}\" type=\"{}\">\n",
                                 name_text(solid.material.name), law.type);
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("      <{0}>{1}</{0}>\n", name, value);
  };
  if (solid.material.density > 0) add("density", format_number(solid.material.density));
  for (const auto& [name, value] : law.parameters) add(name, value);
  return text + "    </material>\n  </Material>\n";
}

template <class Elements>
std::string elements_text(const Elements& elements, const char* type, const char* name, int first) {
  if (elements.cols() == 0) return "";
  std::string text = fmt::format("    <Elements type=\"{}\" name=\"{}\">\n", type, name);
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    std::vector<int> nodes;
    for (const int node : elements.col(e)) nodes.push_back(node + 1);
    text += fmt::format("      <elem id=\"{}\">{}</elem>\n", first + static_cast<int>(e) + 1,
                        fmt::join(nodes, ","));
  }
  return text + "    </Elements>\n";
}

std::string set_text(const char* kind, const std::string& name, std::vector<int> members) {
  for (int& member : members) ++member;
  return fmt::format("    <{0} name=\"{1}\">{2}</{0}>\n", kind, name_text(name),
                     fmt::join(members, ","));
}

std::string regions_text(const VolumeMesh& mesh) {
  const std::map<int, std::vector<int>> regions = elements_of_regions(mesh);
  if (regions.size() < 2 && mesh.region_names.empty()) return "";
  std::string text;
  for (const auto& [label, elements] : regions) {
    const auto named = mesh.region_names.find(label);
    const std::string name =
        named == mesh.region_names.end() ? fmt::format("region {}", label) : named->second;
    text += set_text("ElementSet", name, elements);
  }
  return text;
}

std::string mesh_text(const VolumeMesh& mesh, const std::string& material) {
  std::string text = "  <Mesh>\n    <Nodes name=\"nodes\">\n";
  for (int i = 0; i < mesh.node_count(); ++i) {
    const auto p = mesh.positions.col(i);
    text += fmt::format("      <node id=\"{}\">{},{},{}</node>\n", i + 1, format_number(p.x()),
                        format_number(p.y()), format_number(p.z()));
  }
  text += "    </Nodes>\n";
  text += elements_text(mesh.tetrahedra, "tet4", kTetrahedra, 0);
  text += elements_text(mesh.hexahedra, "hex8", kHexahedra, mesh.tetrahedron_count());
  for (const auto& [group, nodes] : mesh.groups) text += set_text("NodeSet", group, nodes);
  text += regions_text(mesh) + "  </Mesh>\n  <MeshDomains>\n";
  for (const auto& [name, count] : {std::pair(kTetrahedra, mesh.tetrahedron_count()),
                                    std::pair(kHexahedra, mesh.hexahedron_count())}) {
    if (count == 0) continue;
    text += fmt::format("    <SolidDomain name=\"{}\" mat=\"{}\"/>\n", name, name_text(material));
  }
  return text + "  </MeshDomains>\n";
}

/// Two hyphens end a comment.
std::string comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) {
    text.replace(at, 2, "- ");
  }
  return fmt::format("  <!-- {} -->\n", one_line(text, 250));
}

}  // namespace

ConvertedSolid febio_file(const SolidToConvert& solid) {
  LawWriter writer(solid);
  const FebioLaw law = writer.law();
  ConvertedSolid file;
  file.lost = solid.law.lost;
  file.lost.insert(file.lost.end(), writer.lost().begin(), writer.lost().end());
  if (solid.mesh && solid.mesh->tetrahedron_count() > 0 &&
      solid.material.components.contains("J")) {
    file.lost.emplace_back(
        "one volume a node of tetrahedra: tet4 has one an element, and is too stiff where the "
        "volume hardly changes");
  }
  file.text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<febio_spec version=\"4.0\">\n";
  file.text += comment(fmt::format("{}: {}, written by pliant convert in SI units",
                                   solid.material.name, name_of(solid.law)));
  for (const std::string& lost : file.lost) file.text += comment("lost: " + lost);
  file.text += "  <Module type=\"solid\"/>\n" + material_text(solid, law);
  if (solid.mesh) file.text += mesh_text(*solid.mesh, solid.material.name);
  file.text += "</febio_spec>\n";
  return file;
}

}  // namespace pliant
