#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/estimation/problem.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// A strain that sheets have in tests, where nothing is known of them yet.
inline constexpr double kUsualStrain = 0.01;

/// Shapes of the equilibria of tests by name, where searches for the next may begin.
using SheetGuesses = std::map<std::string, std::vector<Eigen::Matrix3Xd>>;

/// Widths of the loops of cords (N), by the names of their parameters.
using CordFrictions = std::map<std::string, double>;

/// What a fit of some groups of a material to some tests of sheets minimises: the differences of
/// forces or positions of all frames in units of their size, all positions counting no more than
/// all forces beside them. Unknowns are the numbers of the groups, the limits of energies of
/// theirs, then the friction of cords, test by test.
class SheetProblem {
 public:
  /// @param tests     outlive the problem
  /// @param material  complete; says where a search begins
  /// @param strains   largest strain of each group, for bounds and scales of friction
  /// @param cords     friction of cords where a search begins
  /// @param with_cords  whether it is looked for where nobody knows it; else it counts as 0
  /// @param options   bounds, fixed values and priors
  SheetProblem(std::vector<const SheetTest*> tests, const Material& material,
               std::vector<ComponentGroup> groups, const std::vector<double>& strains,
               const RunContext& context, const CordFrictions& cords = {},
               const FitOptions& options = {}, bool with_cords = true);

  const std::vector<const SheetTest*>& tests() const { return tests_; }
  const Problem& rows() const { return problem_; }
  const std::vector<Unknown>& unknowns() const { return problem_.unknowns(); }
  Eigen::VectorXd start() const { return starts_of(unknowns()); }
  Material material_at(const Eigen::VectorXd& values) const;
  /// Adds the frictions of cords.
  void keep_cords(const Eigen::VectorXd& values, CordFrictions& cords) const;

  /// Standard deviation of what is measured (N or m) beside that of the first test's kind, against
  /// which priors are weighed; where L rows go together as one, sqrt(L) times that.
  void set_noise(double noise);
  /// Root mean square of the measured differences (N or m) at a solution of `least_squares`.
  double rms(const LeastSquaresSummary& solution) const;
  LeastSquaresProblem least_squares() const { return problem_.least_squares(); }

  /// Searches begin at these shapes instead of the measured ones, of tests that have any.
  void begin_at(const SheetGuesses& guesses);
  /// Adds the shapes that were found last.
  void keep(SheetGuesses& guesses) const;

 private:
  std::vector<const SheetTest*> tests_;
  Material material_;
  std::vector<ComponentGroup> groups_;
  std::vector<double> scales_;   // size of what each test measures (N or m)
  std::vector<double> spreads_;  // how much larger its differences count as
  double noise_;
  Problem problem_;
};

/// The law that a group shares: that of its first component.
ComponentLaw law_of(const Material& material, const ComponentGroup& group);

/// Gives all components of a group a law.
void set_law(Material& material, const ComponentGroup& group, const ComponentLaw& law);

/// The unknowns of some groups of a material that sheets are simulated with.
/// @param strains  largest strain of each group
/// @param cell     of the mesh (m), which limits springs that bend
std::vector<Unknown> unknowns_of(const Material& material,
                                 const std::vector<ComponentGroup>& groups,
                                 const std::vector<double>& strains, double cell);

/// The limits of a material that are about components of some groups.
/// @return places in `Material::limits`
std::vector<std::size_t> limits_of(const Material& material,
                                   const std::vector<ComponentGroup>& groups);

/// The friction of a test's cords, where it is unknown, beginning where it was found.
std::vector<Unknown> cord_unknowns(const SheetTest& test, const CordFrictions& found);

/// The width of the loop of each cord of a test (N): as it was found, else as it is stated; 0 where
/// it is unknown and was not found.
Eigen::VectorXd cord_widths(const SheetTest& test, const CordFrictions& found);

}  // namespace pliant
