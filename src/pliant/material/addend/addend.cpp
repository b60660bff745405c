#include "pliant/material/addend/addend.h"

#include <map>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

using LaneNumbers = Eigen::Array<double, kLanes, Eigen::Dynamic>;

/// One material point, as eight that are alike: laws answer eight at once.
class OnePoint {
 public:
  OnePoint(double strain, double last, const Eigen::VectorXd& history)
      : strain_(LaneNumbers::Constant(kLanes, 1, strain)),
        last_(LaneNumbers::Constant(kLanes, 1, last)),
        history_(history.transpose().replicate(kLanes, 1)) {}

  Samples samples() const {
    const LaneView last(last_.data(), kLanes, 1);
    return {LaneView(strain_.data(), kLanes, 1), last, last,
            LaneView(history_.data(), kLanes, history_.cols())};
  }

 private:
  LaneNumbers strain_, last_, history_;
};

}  // namespace

Addend::Addend(const AddendKind& kind, const Eigen::VectorXd& values)
    : kind_(&kind), values_(values), density_(kind.density(0, values)) {
  PLIANT_ASSERT(values.size() == std::ssize(kind.parameters), "one value a parameter");
}

double Addend::range_stiffness() const {
  constexpr double kFirstStep = 1e-12;  // where two ways part, it is the way on that counts
  if (is_elastic() || is_friction() || flows()) return 0;
  return at(kFirstStep, 0, Eigen::VectorXd::Zero(history_size())).tangent;
}

Addend Addend::scaled(double factor) const {
  Eigen::VectorXd values = values_;
  for (std::size_t i = 0; i < kind_->parameters.size(); ++i) {
    if (kind_->parameters[i].scales) values(static_cast<Eigen::Index>(i)) *= factor;
  }
  return {*kind_, values};
}

Addend::Answer Addend::at(double strain, double last, const Eigen::VectorXd& history,
                          double seconds) const {
  const OnePoint point(strain, last, history);
  Response response(1);
  density_->add(point.samples(), {.seconds = seconds}, response);
  return {response.stress(0, 0), response.tangent(0, 0), response.stored(0), response.work(0)};
}

SampleDerivatives Addend::derivatives(double strain, double last, const Eigen::VectorXd& history,
                                      double seconds) const {
  const OnePoint point(strain, last, history);
  SampleDerivatives result(1, history_size(), size());
  density_->differentiate(point.samples(), {.seconds = seconds}, /*lane=*/0, 0, 0, result);
  return result;
}

Eigen::VectorXd Addend::advanced(double strain, double last, const Eigen::VectorXd& history,
                                 double seconds) const {
  const OnePoint point(strain, last, history);
  LaneNumbers next(kLanes, history_size());
  Lane work = Lane::Zero();
  density_->advance(point.samples(), {.seconds = seconds},
                    MutableLaneView(next.data(), kLanes, next.cols()), work);
  return next.row(0).transpose();
}

std::vector<std::string> parameter_names(const std::vector<Addend>& addends) {
  std::vector<std::string> names;
  std::map<std::string_view, int> count;
  for (const Addend& addend : addends) {
    std::string prefix(addend.kind().name);
    if (const int number = ++count[addend.kind().name]; number > 1) {
      prefix += std::to_string(number);
    }
    for (const AddendParameter& parameter : addend.kind().parameters) {
      names.push_back(prefix + "." + std::string(parameter.name));
    }
  }
  return names;
}

}  // namespace pliant
