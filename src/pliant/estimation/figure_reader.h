#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pliant/estimation/lab_figures.h"

namespace pliant {

/// A number that is read off a component.
using FigureReading = std::function<std::optional<double>(const MaterialComponent&)>;

/// Reads the figures of a component, with the errors that those of its law's parameters make.
class FigureReader {
 public:
  /// @param error_of  outlives the reader
  FigureReader(const Material& material, std::string name, const ErrorOfLaw& error_of);

  const MaterialComponent& component() const { return component_; }
  /// Strain at which the range of the data ends; 0 where it is not known.
  double end() const { return component_.range ? component_.range->second : 0; }

  /// @param from, to  strains between which the law is read
  void add(const char* name, const char* unit, const FigureReading& read, double from, double to,
           std::optional<double> at = std::nullopt);

  std::vector<LabFigure> take() { return std::move(all_); }

 private:
  bool is_beyond(double from, double to) const;
  std::optional<CurveError> error(const FigureReading& read) const;
  std::optional<double> read_with(const ComponentLaw& law, Eigen::Index parameter, double step,
                                  const FigureReading& read) const;
  Eigen::VectorXd steps_of(const ComponentLaw& law) const;

  std::string name_;
  MaterialComponent component_;
  const ErrorOfLaw& error_of_;
  std::vector<LabFigure> all_;
};

}  // namespace pliant
