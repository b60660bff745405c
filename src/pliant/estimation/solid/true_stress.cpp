#include "pliant/estimation/solid/true_stress.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/experiment/stored_rows.h"

namespace pliant {
namespace {

/// An experiment whose stresses are taken for true ones: over the area at rest they are those over
/// the stretch.
class AsTrueStress : public Experiment {
 public:
  explicit AsTrueStress(const Experiment& given, const std::vector<double>& pulled)
      : given_(given) {
    info_ = given.info();
    measured_ = given.measured();
    for (Eigen::Index i = 0; i < measured_.size(); ++i) {
      measured_(i) /= 1 + pulled[static_cast<std::size_t>(i)];
    }
  }

  std::vector<Frame> frames() const override { return given_.frames(); }
  std::vector<std::vector<int>> series() const override { return given_.series(); }
  double reference() const override { return measured_.cwiseAbs().maxCoeff(); }
  Eigen::ArrayXd weights() const override { return given_.weights(); }
  std::unique_ptr<Predictor> predictor(const Material& material) const override {
    return given_.predictor(material);
  }

 private:
  const Experiment& given_;
};

/// Whether stresses exceed a prediction in the third of the rows that is stretched most: true ones
/// are nominal ones times the stretch.
bool exceeds_where_stretched(const Experiment& experiment, const Eigen::VectorXd& predicted,
                             const std::vector<double>& pulled) {
  std::vector<std::size_t> order(pulled.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t row) { return pulled[row]; });
  double excess = 0;
  for (std::size_t i = order.size() - (order.size() + 2) / 3; i < order.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(order[i]);
    excess += experiment.measured()(row) - predicted(row);
  }
  return excess > 0;
}

}  // namespace

double explained_share(const std::vector<const Experiment*>& experiments,
                       const Material& material) {
  double missed = 0, all = 0;
  for (const Experiment* experiment : experiments) {
    const auto predictor = experiment->predictor(material);
    StoredRows rows(*experiment);
    if (!predictor->predict(predictor->values(), {}, {}, rows)) return 0;
    const Eigen::ArrayXd weights = experiment->weights(), measured = experiment->measured();
    const double mean = (weights * measured).sum() / weights.sum();
    const double unit = std::pow(experiment->reference(), 2);
    missed += (weights * (rows.rows().value.array() - measured).square()).sum() / unit;
    all += (weights * (measured - mean).square()).sum() / unit;
  }
  return 1 - missed / all;
}

std::vector<std::string> true_stress_questions(const FitSettings& settings,
                                               const Material& material,
                                               const std::vector<const Experiment*>& experiments,
                                               const RunContext& context) {
  constexpr double kGood = 0.999;  // as it is: nothing to ask
  constexpr double kWell = 0.998;  // as true ones: a poor law explains many things better
  constexpr double kLess = 0.25;   // of what is missed, where it is taken otherwise
  const double nominal = explained_share(experiments, material);
  if (nominal > kGood) return {};
  int exceeding = 0;  // experiments that do, less those that do not
  std::vector<std::unique_ptr<AsTrueStress>> owned;
  std::vector<const Experiment*> as_true;
  for (const Experiment* experiment : experiments) {
    const auto predictor = experiment->predictor(material);
    const auto pulled = predictor->strains("fibre.x", predictor->values(), {});
    if (std::ssize(pulled) != experiment->rows()) return {};
    StoredRows rows(*experiment);
    if (!predictor->predict(predictor->values(), {}, {}, rows)) return {};
    exceeding += exceeds_where_stretched(*experiment, rows.rows().value, pulled) ? 1 : -1;
    owned.push_back(std::make_unique<AsTrueStress>(*experiment, pulled));
    as_true.push_back(owned.back().get());
  }
  if (exceeding <= 0) return {};
  SolidProblem problem(settings, as_true, context);
  Material other = material;
  if (!std::isfinite(problem.solve(other).cost)) return {};
  const double as_true_share = explained_share(as_true, other);
  if (as_true_share < kWell || !(1 - as_true_share < kLess * (1 - nominal))) return {};
  return {fmt::format(
      "the material explains R^2 = {:.4f} of the stresses as nominal ones (force over the area at "
      "rest), exceeded by those of the largest stretches, and would explain {:.4f} if they were "
      "true "
      "ones (over the area as it is): which are they?",
      nominal, as_true_share)};
}

}  // namespace pliant
