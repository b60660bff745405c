#include "pliant/experiment/component_experiment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

class ComponentPredictor : public Predictor {
 public:
  ComponentPredictor(const ComponentExperiment& experiment, const ComponentLaw& law)
      : experiment_(experiment), law_(law), frames_(experiment.frames()) {
    parameters_ = parameter_names(law, experiment.info().component);
    values_ = law.parameters();
    append_nuisance(experiment.nuisance(), parameters_, values_);
  }

  bool predict(const Eigen::VectorXd& values, const std::vector<int>& by, const Workers&,
               FrameSink& rows) override {
    const auto prediction = predict(values, !by.empty());
    if (!prediction) return false;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const auto [first, count, specimen] = frames_[f];
      PredictedFrame frame;
      frame.value = prediction->value.segment(first, count);
      if (!by.empty()) frame.by = prediction->jacobian.middleRows(first, count)(Eigen::all, by);
      if (prediction->length_gain.size() > 0) {
        frame.length_gain = prediction->length_gain.segment(first, count);
      }
      rows.take(static_cast<int>(f), frame);
    }
    return true;
  }

  std::vector<double> strains(const std::string&, const Eigen::VectorXd& values,
                              const Workers&) override {
    const auto prediction = predict(values);
    if (!prediction) return {};
    return {prediction->strain.begin(), prediction->strain.end()};
  }

  std::vector<int> lost_frames(const Eigen::VectorXd& values, const Workers&) override {
    if (predict(values)) return {};
    std::vector<int> all(frames_.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

 private:
  std::optional<Prediction> predict(const Eigen::VectorXd& values, bool derivatives = false) const {
    const Eigen::VectorXd nuisance = values.tail(values.size() - law_.parameter_count());
    return experiment_.predict(law_.with_parameters(values), nuisance, derivatives);
  }

  const ComponentExperiment& experiment_;
  ComponentLaw law_;
  std::vector<Frame> frames_;
};

}  // namespace

std::vector<Frame> ComponentExperiment::frames() const {
  std::vector<Frame> frames;
  for (int row = 0; row < rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const bool goes_on = row > 0 && path_.anchor[i] == path_.anchor[i - 1] &&
                         path_.specimen[i] == path_.specimen[i - 1];
    if (!goes_on) frames.push_back({row, 0, path_.specimen[i]});
    ++frames.back().count;
  }
  return frames;
}

std::vector<std::vector<int>> ComponentExperiment::series() const {
  std::vector<std::vector<int>> series;
  for (int row = 0; row < rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (row == 0 || path_.specimen[i] != path_.specimen[i - 1]) series.emplace_back();
    series.back().push_back(row);
  }
  return series;
}

std::unique_ptr<Predictor> ComponentExperiment::predictor(const Material& material) const {
  const std::optional<ComponentLaw> law = law_of(material, info_.component);
  PLIANT_ASSERT(law.has_value(), "a fit begins with a material that has the component");
  return predictor(*law);
}

std::unique_ptr<Predictor> ComponentExperiment::predictor(const ComponentLaw& law) const {
  return std::make_unique<ComponentPredictor>(*this, law);
}

double ComponentExperiment::reference() const {
  if (info_.quantity.kind == "length") return measured_.maxCoeff() - measured_.minCoeff();
  return measured_.cwiseAbs().maxCoeff();
}

double ComponentExperiment::time_at(int row) const {
  return info_.time.empty() ? kEndless : info_.time[static_cast<std::size_t>(row)];
}

std::span<const double> ComponentExperiment::times_of(const SpecimenRows& rows) const {
  if (info_.time.empty()) return {};
  return std::span(info_.time)
      .subspan(static_cast<std::size_t>(rows.first), static_cast<std::size_t>(rows.count));
}

double ComponentExperiment::peak_force() const {
  double peak = 0;
  for (const double force : path_.force) peak = std::max(peak, std::abs(force));
  return peak;
}

}  // namespace pliant
