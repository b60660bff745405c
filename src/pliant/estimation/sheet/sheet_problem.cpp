#include "pliant/estimation/sheet/sheet_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/estimation/monotone_stress.h"
#include "pliant/estimation/sampled_numbers.h"

namespace pliant {
namespace {

/// Root mean square of what a test measures: forces, or how far nodes have moved from rest.
double measured_size(const SheetTest& test) {
  double sum = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    SheetShape rest;
    rest.positions = test.session().rest.positions;
    rest.clip_forces =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(test.session().clips.size()));
    sum += (test.measured(frame) - test.predicted(frame, rest)).squaredNorm();
  }
  return std::max(std::sqrt(sum / test.rows()), 1e-12);
}

bool compares_positions(const SheetTest& test) {
  return test.objective() == SheetObjective::positions;
}

/// Tests of one kind weigh alike: a newton is a newton.
std::vector<double> first_scales(const std::vector<const SheetTest*>& tests) {
  std::vector<double> scales(tests.size(), 0);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    for (const SheetTest* other : tests) {
      const bool alike = compares_positions(*other) == compares_positions(*tests[i]);
      if (alike) scales[i] = std::max(scales[i], measured_size(*other));
    }
  }
  return scales;
}

/// How much larger differences of each test count as beside forces: vertices of a sheet miss
/// together what its mesh makes them miss, so that all positions count no more than all forces do,
/// however many there are.
std::vector<double> spreads(const std::vector<const SheetTest*>& tests) {
  double positions = 0, forces = 0;
  for (const SheetTest* test : tests) {
    (compares_positions(*test) ? positions : forces) += test->weights().sum();
  }
  const double spread = forces > 0 ? std::max(std::sqrt(positions / forces), 1.0) : 1;
  std::vector<double> all;
  for (const SheetTest* test : tests) all.push_back(compares_positions(*test) ? spread : 1);
  return all;
}

/// The largest stiffness of a law: of its curve, or where that is one of energies or addends alone
/// carry it, at a strain.
double stiffness_size(const ComponentLaw& law, double strain) {
  const std::vector<double>& values = law.stiffness.values();
  const bool by_value = !values.empty() && law.stiffness.kind() != CurveKind::energy;
  return by_value ? *std::ranges::max_element(values) : law.elastic_secant(strain);
}

/// A sheet that gives way freely along a thread at rest, as a curve might that begins with a toe,
/// has no equilibria between clips.
void keep_stiff(const ComponentLaw& law, double stiffness, std::vector<Unknown>& unknowns) {
  constexpr double kSoftest = 1e-3;
  for (int i = 0; i < law.stiffness.size(); ++i) {
    Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    unknown.lower = kSoftest * stiffness;
    if (law.stiffness.kind() == CurveKind::energy) {
      unknown.lower *= *unknown.strain * *unknown.strain / 2;
    }
  }
}

/// The stiffness by which the number of a term of two strains is scaled, which begins at 0: what
/// its strains alone resist.
double stiffness_of_threads(const Material& material) {
  return std::max(stiffness_size(law_of(material, ComponentGroup{"stretch.weft"}), kUsualStrain),
                  stiffness_size(law_of(material, ComponentGroup{"stretch.warp"}), kUsualStrain));
}

/// Springs of the second ring have a stiffness in N, as their energy is per length. They resist
/// stretch as well, by their stiffness over a cell, and must leave most of it to the first ring.
void limit_bending_springs(const Material& material, double cell, std::vector<Unknown>& unknowns) {
  constexpr double kShare = 0.1;
  double stretch = INFINITY;
  for (const char* component : {"stretch.weft", "stretch.warp"}) {
    stretch = std::min(stretch, stiffness_size(law_of(material.components.at(component)), 0));
  }
  for (Unknown& unknown : unknowns) {
    if (!is_bending(unknown.owner) || unknown.of_friction) continue;
    unknown.unit = std::string(1, 'N');
    unknown.upper = std::max(kShare * stretch * cell, 1e-9);
  }
}

/// The elastic tangents of all groups, by all unknowns.
Eigen::MatrixXd tangents_of(const Material& material, const std::vector<ComponentGroup>& groups,
                            Eigen::Index unknowns) {
  Eigen::MatrixXd all(0, unknowns);
  Eigen::Index first = 0;
  for (const ComponentGroup& group : groups) {
    const ComponentLaw law = law_of(material, group);
    const Eigen::MatrixXd own = elastic_tangents(law.stiffness, 0);
    for (int copy = 0; copy < copies_of(material, group.front()); ++copy) {
      const Eigen::Index above = all.rows();
      all.conservativeResize(above + own.rows(), Eigen::NoChange);
      all.bottomRows(own.rows()).setZero();
      all.block(above, first, own.rows(), own.cols()) = own;
      first += law.parameter_count();
    }
  }
  return all;
}

Problem problem_of(const std::vector<const SheetTest*>& tests, const Material& material,
                   const std::vector<ComponentGroup>& groups, const std::vector<double>& strains,
                   const RunContext& context, const CordFrictions& cords, const FitOptions& options,
                   bool with_cords) {
  PLIANT_ASSERT(!tests.empty(), "a fit has data");
  std::vector<ProblemPart> parts;
  std::vector<Unknown> unknowns =
      unknowns_of(material, groups, strains, shortest_edge(*tests.front()));
  for (const std::size_t limit : limits_of(material, groups)) {
    unknowns.push_back(unknown_of(material.limits[limit], material.kind));
  }
  for (const SheetTest* test : tests) {
    parts.push_back({test, test->predictor(material), {}});
    if (!with_cords) continue;
    const std::vector<Unknown> own = cord_unknowns(*test, cords);
    unknowns.insert(unknowns.end(), own.begin(), own.end());
  }
  apply_options(options, unknowns);
  Problem problem(std::move(parts), std::move(unknowns), {context.threads, context.stop});
  if (options.monotone_stress) {
    problem.set_not_negative(
        tangents_of(material, groups, static_cast<Eigen::Index>(problem.unknowns().size())));
  }
  return problem;
}

}  // namespace

SheetProblem::SheetProblem(std::vector<const SheetTest*> tests, const Material& material,
                           std::vector<ComponentGroup> groups, const std::vector<double>& strains,
                           const RunContext& context, const CordFrictions& cords,
                           const FitOptions& options, bool with_cords)
    : tests_(std::move(tests)),
      material_(material),
      groups_(std::move(groups)),
      scales_(first_scales(tests_)),
      spreads_(spreads(tests_)),
      noise_(scales_.front()),
      problem_(
          problem_of(tests_, material, groups_, strains, context, cords, options, with_cords)) {
  set_noise(noise_);
}

void SheetProblem::set_noise(double noise) {
  noise_ = noise;
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    const double sd = noise * spreads_[t] * scales_[t] / scales_.front();
    problem_.set_weight(t, tests_[t]->weights() * problem_.emphasis(t) / sd);
  }
}

double SheetProblem::rms(const LeastSquaresSummary& solution) const {
  double squares = 2 * solution.cost;
  for (const SumPrior& prior : problem_.priors()) {
    squares -= std::pow(prior.miss(solution.parameters), 2);
  }
  double rows = 0;
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    rows += tests_[t]->weights().sum() / (spreads_[t] * spreads_[t]);
  }
  return noise_ * std::sqrt(std::max(squares, 0.0) / rows);
}

Material SheetProblem::material_at(const Eigen::VectorXd& values) const {
  Material material = material_;
  Eigen::Index next = 0;
  for (const ComponentGroup& group : groups_) next = set_numbers(values, next, group, material);
  for (const std::size_t limit : limits_of(material, groups_)) {
    material.limits[limit].energy = values(next++);
  }
  return material;
}

void SheetProblem::keep_cords(const Eigen::VectorXd& values, CordFrictions& cords) const {
  for (std::size_t u = 0; u < unknowns().size(); ++u) {
    if (!unknowns()[u].of_material)
      cords[unknowns()[u].name] = values(static_cast<Eigen::Index>(u));
  }
}

void SheetProblem::begin_at(const SheetGuesses& guesses) {
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    const auto found = guesses.find(tests_[t]->name());
    if (found != guesses.end()) problem_.begin_at(t, found->second);
  }
}

void SheetProblem::keep(SheetGuesses& guesses) const {
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    std::vector<Eigen::Matrix3Xd> own = problem_.guesses(t);
    if (!own.empty()) guesses[tests_[t]->name()] = std::move(own);
  }
}

ComponentLaw law_of(const Material& material, const ComponentGroup& group) {
  const std::optional<ComponentLaw> law = law_of(material, group.front());
  PLIANT_ASSERT(law.has_value(), "a fit begins with a complete material");
  return *law;
}

void set_law(Material& material, const ComponentGroup& group, const ComponentLaw& law) {
  for (const std::string& name : group) set_law(material.components[name], law);
}

std::vector<Unknown> unknowns_of(const Material& material,
                                 const std::vector<ComponentGroup>& groups,
                                 const std::vector<double>& strains, double cell) {
  PLIANT_ASSERT(strains.size() == groups.size(), "a strain for each group");
  std::vector<Unknown> unknowns;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ComponentLaw law = law_of(material, groups[g]);
    const std::string& name = groups[g].front();
    const double own_stiffness =
        is_sheet_pair(name) ? stiffness_of_threads(material) : stiffness_size(law, strains[g]);
    const double stiffness = std::max(own_stiffness, 1e-12);
    std::vector<Unknown> own = unknowns_of(law, groups[g], {stiffness * strains[g], strains[g]});
    if (!is_bending(name) && !solid_metric_of(name)) keep_stiff(law, stiffness, own);
    append_unknowns(material, groups[g], own, unknowns);
  }
  if (material.bending == "spring") limit_bending_springs(material, cell, unknowns);
  return unknowns;
}

std::vector<std::size_t> limits_of(const Material& material,
                                   const std::vector<ComponentGroup>& groups) {
  const auto is_in_groups = [&](const std::string& component) {
    return std::ranges::any_of(groups, [&](const ComponentGroup& group) {
      return std::ranges::find(group, component) != group.end();
    });
  };
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < material.limits.size(); ++i) {
    if (std::ranges::all_of(material.limits[i].of, is_in_groups)) places.push_back(i);
  }
  return places;
}

std::vector<Unknown> cord_unknowns(const SheetTest& test, const CordFrictions& found) {
  std::vector<Unknown> unknowns = unknowns_of(test);
  for (Unknown& unknown : unknowns) {
    const auto known = found.find(unknown.name);
    if (known != found.end()) unknown.start = known->second;
  }
  return unknowns;
}

Eigen::VectorXd cord_widths(const SheetTest& test, const CordFrictions& found) {
  return test.cord_widths(starts_of(cord_unknowns(test, found)));
}

}  // namespace pliant
