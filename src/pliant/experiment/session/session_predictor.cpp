#include "pliant/experiment/session/session_predictor.h"

#include <algorithm>
#include <utility>

#include "pliant/experiment/session/lost_frames.h"
#include "pliant/experiment/session/make_predictor.h"
#include "pliant/experiment/session/sheet_system.h"

namespace pliant {
namespace {

bool bends_as_sheet(const Material& material) {
  return material.bending == "discrete-shells" && material.bending_of == "sheet";
}

/// Which derivatives a simulation has to give for those that are asked for, and how these follow
/// from them.
struct Chain {
  std::vector<int> simulated;
  Eigen::MatrixXd asked_by_simulated;  // simulated x asked for
};

Chain direct(const std::vector<int>& by) {
  const auto count = static_cast<Eigen::Index>(by.size());
  return {by, Eigen::MatrixXd::Identity(count, count)};
}

Chain through(const Eigen::MatrixXd& by_values, const std::vector<int>& by) {
  Chain chain;
  const Eigen::MatrixXd asked = by_values(Eigen::all, by);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < asked.rows(); ++i) {
    if (asked.row(i).isZero(0)) continue;
    rows.push_back(i);
    chain.simulated.push_back(static_cast<int>(i));
  }
  chain.asked_by_simulated = asked(rows, Eigen::all);
  return chain;
}

/// Takes the numbers of a material that have these names.
void take_values(const Material& material, const std::vector<std::string>& names,
                 Eigen::VectorXd& values) {
  for (const auto& [component, content] : material.components) {
    const auto law = law_of(material, component);
    if (!law) continue;
    const std::vector<std::string> own = parameter_names(*law, component);
    const Eigen::VectorXd parameters = law->parameters();
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto found = std::ranges::find(names, own[i]);
      if (found == names.end()) continue;
      values(found - names.begin()) = parameters(static_cast<Eigen::Index>(i));
    }
  }
}

}  // namespace

SessionPredictor::SessionPredictor(const SheetTest& test, const Material& material)
    : test_(test),
      material_(bends_as_sheet(material) ? as_hinges(material, test.session().rest) : material),
      sheets_(make_predictor(test.session(), material_)) {
  parameters_ = sheets_->parameter_names();
  values_ = sheets_->parameters();
  if (bends_as_sheet(material)) {
    bending_.emplace(test.session().rest, material, parameters_);
    take_values(material, parameters_, values_);
  }
  append_nuisance(test.nuisance(), parameters_, values_);
}

bool SessionPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                               const Workers& workers, FrameSink& rows) {
  const int material_count = of_material(values);
  // Derivatives by the numbers of the material come first, then those by all cords.
  std::vector<int> by_material, columns;
  for (const int parameter : by) {
    if (parameter < material_count) by_material.push_back(parameter);
  }
  bool by_cords = false;
  int next = 0;
  for (const int parameter : by) {
    const bool cord = parameter >= material_count;
    by_cords = by_cords || cord;
    columns.push_back(cord ? static_cast<int>(by_material.size()) + parameter - material_count
                           : next++);
  }
  const Eigen::VectorXd own = values.head(material_count);
  const Chain chain = bending_ && !by_material.empty()
                          ? through(bending_->hinges_by_values(own), by_material)
                          : direct(by_material);
  auto shapes = sheets_->predict(simulated(values), chain.simulated, workers.threads, workers.stop);
  if (!shapes) return false;
  const Eigen::VectorXd widths = test_.cord_widths(values.tail(values.size() - material_count));
  for (int frame = 0; frame < test_.frame_count(); ++frame) {
    SheetShape& shape = (*shapes)[static_cast<std::size_t>(frame)];
    if (bending_ && !by_material.empty()) {
      shape.positions_by_parameter *= chain.asked_by_simulated;
      shape.clip_forces_by_parameter *= chain.asked_by_simulated;
    }
    add_cord_drags(test_.cords(), widths, by_cords, frame, shape);
    PredictedFrame found{test_.predicted(frame, shape), {}, {}};
    if (!by.empty()) found.by = test_.jacobian(frame, shape)(Eigen::all, columns);
    rows.take(frame, found);
  }
  return true;
}

std::vector<double> SessionPredictor::strains(const std::string& component,
                                              const Eigen::VectorXd& values,
                                              const Workers& workers) {
  if (!usually_strains(component)) return {};
  const auto shapes = sheets_->predict(simulated(values), {}, workers.threads, workers.stop);
  if (!shapes) return {};
  const SheetSystem sheet(test_.session(), material_, {.friction = false}, {});
  std::vector<double> strains;
  for (const SheetShape& shape : *shapes) {
    const std::vector<double> own = sheet.strains(component, shape.positions);
    strains.insert(strains.end(), own.begin(), own.end());
  }
  return strains;
}

std::vector<int> SessionPredictor::lost_frames(const Eigen::VectorXd& values,
                                               const Workers& workers) {
  return pliant::lost_frames(
      sheets_->predict_each(simulated(values), {}, workers.threads, workers.stop));
}

int SessionPredictor::of_material(const Eigen::VectorXd& values) const {
  return static_cast<int>(values.size()) - static_cast<int>(test_.nuisance().size());
}

Eigen::VectorXd SessionPredictor::simulated(const Eigen::VectorXd& values) const {
  const Eigen::VectorXd own = values.head(of_material(values));
  return bending_ ? bending_->hinges(own) : own;
}

/// A test of weft says nothing about the strains that warp has.
bool SessionPredictor::usually_strains(const std::string& component) const {
  const std::vector<std::string> usual = usual_components(test_.session().test);
  const bool directed = component.ends_with(".weft") || component.ends_with(".warp");
  if (usual.empty() || !directed || is_sheet_pair(component)) return true;
  const auto family = [](const std::string& name) { return name.substr(0, name.find('.')); };
  return usual.front() == component || family(usual.front()) != family(component);
}

}  // namespace pliant
