#include "pliant/estimation/anchor_predictor.h"

#include "pliant/material/density/dahl_published.h"

namespace pliant {
namespace {

class AnchorPredictor : public Predictor {
 public:
  AnchorPredictor(const ComponentExperiment& experiment, const ComponentLaw& law)
      : experiment_(experiment), law_(law) {
    parameters_ = parameter_names(law, experiment.info().component);
    values_ = law.parameters();
  }

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers&,
               FrameSink& rows) override {
    const ComponentLaw law = law_.with_parameters(values);
    const Eigen::VectorXd nuisance = experiment_.unfitted_nuisance(law);
    const double offset = nuisance.size() > 0 ? nuisance(0) : 0;
    const std::vector<Frame> frames = experiment_.frames();
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const auto [first, count, specimen] = frames[f];
      PredictedFrame found{experiment_.measured().segment(first, count),
                           Eigen::MatrixXd(by.empty() ? 0 : count, by.size()),
                           {}};
      for (int i = 0; i < count; ++i) {
        const ForceError error = error_of(law, static_cast<std::size_t>(first + i));
        found.value(i) += error.force + offset;
        if (!by.empty()) found.by.row(i) = error.by_law(by).transpose();
      }
      rows.take(static_cast<int>(f), found);
    }
    return true;
  }

  std::vector<double> strains(const std::string&, const Eigen::VectorXd&, const Workers&) override {
    return experiment_.path().strain;
  }
  std::vector<int> lost_frames(const Eigen::VectorXd&, const Workers&) override { return {}; }

 private:
  struct ForceError {
    double force = 0;
    Eigen::VectorXd by_law;
  };

  ForceError error_of(const ComponentLaw& law, std::size_t i) const {
    const MeasuredPath& path = experiment_.path();
    const double strain = path.strain[i], factor = path.factor[i];
    const int stiffness = law.stiffness.size();
    FrictionStress friction;
    if (law.friction_law == FrictionLaw::dahl) {
      friction = anchored_friction_stress(
          {law.friction[0], law.friction[1], law.friction[2]}, strain,
          path.strain[static_cast<std::size_t>(path.anchor[i])], path.direction[i]);
    }
    ForceError error;
    error.force = factor * (law.elastic_stress(strain) + friction.stress) - path.force[i];
    error.by_law = factor * law.elastic_gradient(strain);
    for (int k = 0; k < law.friction_count(); ++k) {
      error.by_law(stiffness + k) = factor * friction.parameters[static_cast<std::size_t>(k)];
    }
    return error;
  }

  const ComponentExperiment& experiment_;
  ComponentLaw law_;
};

}  // namespace

std::unique_ptr<Predictor> anchor_predictor(const ComponentExperiment& experiment,
                                            const ComponentLaw& law) {
  return std::make_unique<AnchorPredictor>(experiment, law);
}

}  // namespace pliant
