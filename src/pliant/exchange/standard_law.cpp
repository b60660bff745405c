#include "pliant/exchange/standard_law.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/density/rubber_energies.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/pair_metric.h"

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;

/// The elastic law of a component as far as standard laws can have it.
struct Elasticity {
  std::array<double, 3> powers{};  ///< energy: powers[i - 1] x^i
  std::vector<OgdenLaw::Term> terms;
  std::vector<ArrudaBoyceLaw> chains;
  std::string other;  ///< field of what is none of it, below the component

  bool is_powers_only() const { return terms.empty() && chains.empty() && other.empty(); }
  bool is_nothing() const { return is_powers_only() && powers == std::array<double, 3>{}; }
  /// Whether its energy is c x^power.
  bool is_power(int power) const {
    std::array<double, 3> rest = powers;
    rest[static_cast<std::size_t>(power - 1)] = 0;
    return is_powers_only() && rest == std::array<double, 3>{};
  }
};

void add_addend(const Addend& addend, std::size_t index, Elasticity& elasticity) {
  const Eigen::VectorXd& values = addend.values();
  if (&addend.kind() == &linear_addend() || &addend.kind() == &polynomial_addend()) {
    for (int i = 0; i < addend.size(); ++i) {
      elasticity.powers[static_cast<std::size_t>(i)] += values(i);
    }
  } else if (&addend.kind() == &ogden_addend() && values(1) != 0) {
    elasticity.terms.push_back({values(0), values(1)});
  } else if (&addend.kind() == &arruda_boyce_addend()) {
    elasticity.chains.push_back({values(0), values(1)});
  } else if (elasticity.other.empty()) {
    elasticity.other = fmt::format("addends[{}]", index);
  }
}

Elasticity elasticity_of(const MaterialComponent& component) {
  Elasticity elasticity;
  const ScalarCurve& stiffness = *component.stiffness;
  if (stiffness.kind() == CurveKind::constant) {
    elasticity.powers[1] = stiffness.values().front() / 2;
  } else if (stiffness.kind() != CurveKind::none) {
    elasticity.other = "stiffness";
  }
  for (std::size_t i = 0; i < component.addends.size(); ++i) {
    const Addend& addend = component.addends[i];
    if (addend.is_elastic()) add_addend(addend, i, elasticity);
  }
  return elasticity;
}

/// Adds c (s1^alpha + s2^alpha + s3^alpha - 3).
void add_term(double c, double alpha, std::vector<OgdenLaw::Term>& terms) {
  if (c == 0) return;
  const double mu = c * alpha * alpha / 2;
  const auto found = std::ranges::find(terms, alpha, &OgdenLaw::Term::alpha);
  if (found == terms.end()) {
    terms.push_back({mu, alpha});
  } else {
    found->mu += mu;
  }
}

void add_terms(const std::vector<OgdenLaw::Term>& from, std::vector<OgdenLaw::Term>& to) {
  for (const auto& [mu, alpha] : from) add_term(2 * mu / (alpha * alpha), alpha, to);
}

/// Sorts the components of a material into one law.
class Recogniser {
 public:
  Recogniser(const Material& material, const std::string& file) : material_(material), file_(file) {
    for (const std::string& name : ordered_components(material.components, material.kind)) {
      const MaterialComponent& component = material.components.at(name);
      if (!component.stiffness) continue;
      Elasticity elasticity = elasticity_of(component);
      if (!elasticity.is_nothing()) parts_.emplace_back(name, std::move(elasticity));
    }
  }

  StandardLaw law() const {
    if (!shape_rests_on({})) return law_of_shape();
    throw InputError({file_, 0, "components"}, "have no elastic law that resists a change of shape",
                     "a solid with the numbers of a standard law");
  }

 private:
  const Elasticity* part(std::string_view name) const {
    const auto found = std::ranges::find(parts_, name, &Part::first);
    return found == parts_.end() ? nullptr : &found->second;
  }
  bool has(std::string_view name) const { return part(name) != nullptr; }
  double power(std::string_view name, int power) const {
    const Elasticity* found = part(name);
    return found ? found->powers[static_cast<std::size_t>(power - 1)] : 0;
  }

  /// Whether no components but these, and those of the volume, have a part in the law.
  bool shape_rests_on(std::initializer_list<std::string_view> names) const {
    return std::ranges::all_of(parts_, [&](const Part& part) {
      return part.first == "J" || part.first == "log-J" ||
             std::ranges::find(names, part.first) != names.end();
    });
  }

  StandardLaw law_of_shape() const {
    if (shape_rests_on({"trace", "trace-of-square"})) return stvk();
    if (std::ranges::all_of(parts_, [](const Part& part) { return is_orthotropic(part.first); })) {
      return orthotropic_stvk();
    }
    if (shape_rests_on({"I1", "I2"})) return coupled_mooney_rivlin();
    if (shape_rests_on({"stretch"})) return unconstrained_ogden();
    if (shape_rests_on({"I1-bar"}) && part("I1-bar")->chains.size() == 1) return arruda_boyce();
    if (shape_rests_on({"I1-bar", "I2-bar"})) return of_invariants();
    if (shape_rests_on({"I1-bar", "I2-bar", "stretch-bar"})) return of_stretches();
    refuse_mixture();
  }

  StandardLaw stvk() const {
    require("trace", 2);
    require("trace-of-square", 1);
    for (const char* volume : {"J", "log-J"}) {
      if (has(volume)) refuse(volume, "", "has no part in StVK, whose volume is in `trace`");
    }
    const StvkLaw law{2 * power("trace", 2), power("trace-of-square", 1)};
    if (3 * law.lambda + 2 * law.mu <= 0) refuse("trace", "", "resists no change of volume");
    return {law, {}, {}};
  }

  static bool is_orthotropic(const std::string& name) {
    const auto pair = find_pair_metric(name);
    return name.starts_with("green.") && !(pair && pair->bump);
  }

  StandardLaw orthotropic_stvk() const {
    constexpr std::string_view kAxes = "xyz";
    OrthotropicStvkLaw law;
    for (const auto& [name, elasticity] : parts_) {
      const bool is_pair = name.find('*') != std::string::npos;
      require(name.c_str(), is_pair ? 1 : 2);
      // "green.xx", "green.xx+yy", "green.xx*green.yy", "green.yz"
      const auto first = static_cast<Eigen::Index>(kAxes.find(name[6])),
                 last = static_cast<Eigen::Index>(kAxes.find(name.back()));
      const bool is_shear = name.size() == 8 && first != last;
      if (is_shear) {
        law.shear(3 - first - last) += 2 * elasticity.powers[1];
      } else if (is_pair) {
        law.normal(first, last) += elasticity.powers[0];
        law.normal(last, first) += elasticity.powers[0];
      } else {
        Eigen::Vector3d of = Eigen::Vector3d::Zero();
        of(first) = of(last) = 1;
        law.normal += 2 * elasticity.powers[1] * of * of.transpose();
      }
    }
    const Eigen::LLT<Eigen::Matrix3d> stable(law.normal);
    if (stable.info() == Eigen::Success && law.shear.minCoeff() > 0) return {law, {}, {}};
    throw InputError({file_, 0, "components"}, "do not resist every small strain",
                     "normal strains and shears of all axes that together do");
  }

  StandardLaw coupled_mooney_rivlin() const {
    require("I1", 1);
    require("I2", 1);
    const CoupledMooneyRivlinLaw law{power("I1", 1), power("I2", 1)};
    const double needed = -2 * (law.first + 2 * law.second), given = power("log-J", 1);
    const Elasticity* log = part("log-J");
    if (has("J")) refuse("J", "", "is beside `I1` and `I2` in no standard law");
    if (!log || !log->is_powers_only() || log->powers[2] != 0 || log->powers[1] <= 0 ||
        std::abs(given - needed) > kRounding * std::abs(needed)) {
      throw InputError({file_, 0, "components.log-J"},
                       "makes no standard law of what `I1` and `I2` have",
                       fmt::format("an addend linear of c = {}, and a constant stiffness", needed));
    }
    return {law, {VolumeEnergy::Form::of_log, 2 * log->powers[1]}, {}};
  }

  StandardLaw unconstrained_ogden() const {
    const Elasticity& stretch = *part("stretch");
    require_nothing_but_terms("stretch");
    if (stretch.powers != std::array<double, 3>{}) {
      refuse("stretch", "", "has powers of the stretch that are stressed at rest");
    }
    OgdenLaw law{{}, false};
    add_terms(stretch.terms, law.terms);
    return {std::move(law), volume(), {}};
  }

  StandardLaw arruda_boyce() const {
    const Elasticity& first = *part("I1-bar");
    require_nothing_but_terms("I1-bar");
    if (!first.terms.empty() || first.powers != std::array<double, 3>{}) {
      refuse("I1-bar", "", "has more than arruda-boyce: no standard law has both");
    }
    return {first.chains.front(), volume(), {}};
  }

  StandardLaw of_invariants() const {
    InvariantLaw law;
    if (const Elasticity* first = part("I1-bar")) {
      require_powers("I1-bar");
      law.first = first->powers;
    }
    require("I2-bar", 1);
    law.second = power("I2-bar", 1);
    return {law, volume(), {}};
  }

  /// I1-bar is the sum of the squares of the stretches, I2-bar that of their inverses' squares.
  StandardLaw of_stretches() const {
    const Elasticity& stretch = *part("stretch-bar");
    require_nothing_but_terms("stretch-bar");
    require("I1-bar", 1);
    require("I2-bar", 1);
    OgdenLaw law;
    add_terms(stretch.terms, law.terms);
    const auto& [c1, c2, c3] = stretch.powers;
    add_term(c1 - 2 * c2 + 3 * c3, 1, law.terms);
    add_term(c2 - 3 * c3 + power("I1-bar", 1), 2, law.terms);
    add_term(c3, 3, law.terms);
    add_term(power("I2-bar", 1), -2, law.terms);
    return {std::move(law), volume(), {}};
  }

  VolumeEnergy volume() const {
    const Elasticity *ratio = part("J"), *log = part("log-J");
    if (!ratio && !log) return {};
    const auto elastic = [&](const char* name) {
      const auto found = material_.components.find(name);
      return found == material_.components.end() || !found->second.stiffness
                 ? ComponentLaw{}
                 : law_of(found->second).elastic_part();
    };
    const ComponentLaw of_ratio = elastic("J"), of_log = elastic("log-J");
    const double stress = of_ratio.elastic_stress(0) + of_log.elastic_stress(0);
    // d2/dJ2 of f(ln J) is f'' - f' at rest.
    const double bulk =
        of_ratio.elastic_tangent(0) + of_log.elastic_tangent(0) - of_log.elastic_stress(0);
    if (std::abs(stress) > kRounding * std::abs(bulk) || !(bulk > 0)) {
      refuse(ratio ? "J" : "log-J", "", "is stressed at rest, or resists no change of volume");
    }
    if (!log && ratio->is_power(2)) return {VolumeEnergy::Form::of_ratio, bulk};
    if (!ratio && log->is_power(2)) return {VolumeEnergy::Form::of_log, bulk};
    if (ratio && log && is_of_square(*ratio, *log)) return {VolumeEnergy::Form::of_square, bulk};
    return {VolumeEnergy::Form::something, bulk};
  }

  /// (J^2 - 1) / 2 - ln J is (J - 1) + (J - 1)^2 / 2 - ln J.
  static bool is_of_square(const Elasticity& ratio, const Elasticity& log) {
    const double half = ratio.powers[0];
    const auto is_near = [&](double a, double b) { return std::abs(a - b) <= kRounding * half; };
    return ratio.is_powers_only() && log.is_power(1) && ratio.powers[2] == 0 &&
           is_near(2 * ratio.powers[1], half) && is_near(-log.powers[0], half);
  }

  void require(const char* name, int power) const {
    if (!has(name)) return;
    require_powers(name);
    if (part(name)->is_power(power)) return;
    refuse(name, "",
           power == 1 ? "has powers of its strain that no standard law has"
                      : "has another energy than a constant stiffness");
  }

  void require_powers(const char* name) const {
    const Elasticity& found = *part(name);
    require_nothing_but_terms(name);
    if (!found.chains.empty()) refuse(name, "", "has an addend arruda-boyce beside other laws");
    if (!found.terms.empty()) refuse(name, "", "has an addend ogden, which is one of stretches");
  }

  void require_nothing_but_terms(const char* name) const {
    const std::string& other = part(name)->other;
    if (!other.empty()) refuse(name, "." + other, "is in no standard law");
    if (std::string_view(name) != "I1-bar" && !part(name)->chains.empty()) {
      refuse(name, "", "has an addend arruda-boyce, which is one of I1-bar");
    }
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& below,
                           const std::string& problem) const {
    throw InputError(
        {file_, 0, "components." + name + below}, problem,
        "StVK (orthotropic, too), Neo-Hookean, Mooney-Rivlin, Yeoh, Ogden or Arruda-Boyce");
  }

  /// Names the first component that the ones before make no law with.
  [[noreturn]] void refuse_mixture() const {
    static constexpr std::string_view kKnown[] = {
        "trace", "trace-of-square", "I1", "I2", "stretch", "I1-bar", "I2-bar", "stretch-bar"};
    for (const auto& [name, part] : parts_) {
      const bool known = std::ranges::find(kKnown, name) != std::end(kKnown);
      if (!known && name != "J" && name != "log-J") refuse(name, "", "is in no standard law");
    }
    throw InputError(
        {file_, 0, "components"}, "make no standard law together",
        "StVK (orthotropic, too), Neo-Hookean, Mooney-Rivlin, Yeoh, Ogden or Arruda-Boyce");
  }

  using Part = std::pair<std::string, Elasticity>;
  const Material& material_;
  const std::string& file_;
  std::vector<Part> parts_;  // those with an elastic law
};

/// What the file tells about its numbers: "ranges of the data, errors"; may be empty.
std::string told_about_numbers(const Material& material) {
  const auto any = [&](auto has) {
    return std::ranges::any_of(material.components, [&](const auto& c) { return has(c.second); });
  };
  std::vector<std::string> told;
  if (any([](const auto& c) { return c.status == ComponentStatus::assumed; })) {
    told.emplace_back("which are assumed");
  }
  if (any([](const auto& c) { return c.range.has_value(); })) {
    told.emplace_back("ranges of the data");
  }
  if (any([](const auto& c) { return !c.errors.empty(); })) told.emplace_back("errors");
  if (!material.info.empty()) told.emplace_back("info");
  if (!material.provenance.empty()) told.emplace_back("provenance");
  return fmt::format("{}", fmt::join(told, ", "));
}

std::vector<std::string> what_is_lost(const Material& material) {
  std::vector<std::string> lost;
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    const MaterialComponent& component = material.components.at(name);
    if (!component.stiffness) lost.push_back("that " + name + " was not measured");
    bool friction = component.friction.has_value(), plastic = false;
    for (const Addend& addend : component.addends) {
      if (addend.is_friction()) friction = true;
      if (!addend.is_elastic() && !addend.is_friction()) plastic = true;
    }
    if (friction) lost.push_back("internal friction of " + name);
    if (plastic) lost.push_back("plasticity of " + name + ", with its elastic range");
  }
  for (const EnergyLimit& limit : material.limits) {
    lost.push_back("the limit of energy " + limit_name(limit.of));
  }
  if (material.damping_fraction.value_or(0) > 0) lost.emplace_back("damping");
  const std::string told = told_about_numbers(material);
  if (!told.empty()) lost.push_back("what is told about the numbers: " + told);
  return lost;
}

std::string name_of_shape(const StvkLaw&) { return "St. Venant-Kirchhoff"; }

std::string name_of_shape(const OrthotropicStvkLaw&) { return "orthotropic St. Venant-Kirchhoff"; }

std::string name_of_shape(const InvariantLaw& law) {
  const bool linear = law.first[1] == 0 && law.first[2] == 0;
  if (law.second == 0) return linear ? "Neo-Hookean" : "Yeoh";
  return linear ? "Mooney-Rivlin" : "Mooney-Rivlin with Yeoh's terms";
}

std::string name_of_shape(const OgdenLaw& law) {
  return fmt::format("{}Ogden of {} term{}", law.isochoric ? "" : "unconstrained ",
                     law.terms.size(), law.terms.size() == 1 ? "" : "s");
}

std::string name_of_shape(const ArrudaBoyceLaw&) { return "Arruda-Boyce"; }

std::string name_of_shape(const CoupledMooneyRivlinLaw& law) {
  return law.second == 0 ? "coupled Neo-Hookean" : "coupled Mooney-Rivlin";
}

double shear_of(const StvkLaw& law) { return law.mu; }

double shear_of(const OrthotropicStvkLaw& law) { return law.shear.minCoeff(); }

double shear_of(const InvariantLaw& law) { return 2 * (law.first[0] + law.second); }

double shear_of(const OgdenLaw& law) {
  return std::accumulate(law.terms.begin(), law.terms.end(), 0.0,
                         [](double sum, const auto& term) { return sum + term.mu; });
}

double shear_of(const ArrudaBoyceLaw& law) { return 2 * powers_of(law)[0]; }

double shear_of(const CoupledMooneyRivlinLaw& law) { return 2 * (law.first + law.second); }

}  // namespace

StandardLaw standard_law(const Material& material, const std::string& file) {
  if (material.kind != MaterialKind::solid) {
    throw InputError({file, 0, "kind"}, "is a cloth: other tools have no law of its components",
                     "a material of kind solid");
  }
  if (is_heterogeneous(material)) {
    throw InputError({file, 0, "samples"}, "make the solid heterogeneous, which is no standard law",
                     "a material that is the same everywhere");
  }
  StandardLaw law = Recogniser(material, file).law();
  law.lost = what_is_lost(material);
  if (shear_modulus(law) > 0) return law;
  throw InputError({file, 0, "components"}, "have a shear modulus at rest that is not above 0",
                   "a solid that resists small changes of shape");
}

std::string name_of(const StandardLaw& law) {
  return std::visit([](const auto& shape) { return name_of_shape(shape); }, law.shape);
}

double shear_modulus(const StandardLaw& law) {
  return std::visit([](const auto& shape) { return shear_of(shape); }, law.shape);
}

std::array<double, 5> powers_of(const ArrudaBoyceLaw& law) {
  // (x + 3)^i - 3^i = sum_k binomial(i, k) 3^(i - k) x^k, k from 1.
  static_assert(kSeriesOfChains.size() == 5);
  std::array<double, 5> powers{};
  double scale = law.mu;
  for (int i = 1; i <= 5; ++i) {
    double binomial = 1;
    for (int k = 1; k <= i; ++k) {
      binomial *= static_cast<double>(i - k + 1) / k;
      powers[static_cast<std::size_t>(k - 1)] +=
          scale * kSeriesOfChains[static_cast<std::size_t>(i - 1)] * binomial * std::pow(3, i - k);
    }
    scale /= law.lock * law.lock;
  }
  return powers;
}

}  // namespace pliant
