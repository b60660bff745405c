#include "pliant/material/addend/addend_kind.h"

#include <cmath>

#include <fmt/format.h>

namespace pliant {

std::string unit_of(const AddendParameter& parameter, LawUnits units) {
  if (parameter.time == 1) return "s";
  const bool bending = units == LawUnits::bending;
  if (units == LawUnits::ratio) return "1";
  if (units == LawUnits::solid) return parameter.stress != 0 ? "Pa" : "1";
  const std::string_view stress = bending ? "N" : "N/m";
  // A bending strain is 1/m, a membrane strain has no unit.
  const int metres = bending ? -parameter.strain : 0;
  const bool has_stress = parameter.stress != 0;
  if (metres == 0) return std::string(has_stress ? stress : "1");
  if (metres == -1) return has_stress ? "N/m" : "1/m";
  const std::string length = metres == 1 ? "m" : fmt::format("m^{}", metres);
  return has_stress ? fmt::format("{} {}", stress, length) : length;
}

bool remembers(const AddendKind& kind) {
  const Eigen::VectorXd any = Eigen::VectorXd::Ones(std::ssize(kind.parameters));
  return kind.density(0, any)->history_size() > 0;
}

double data_unit(const AddendParameter& parameter, double stress, double strain, double seconds) {
  return std::pow(stress, parameter.stress) * std::pow(strain, parameter.strain) *
         std::pow(seconds, parameter.time);
}

}  // namespace pliant
