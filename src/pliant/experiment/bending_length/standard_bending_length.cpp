#include "pliant/experiment/bending_length/standard_bending_length.h"

#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json spread_json(const std::string& face, const BendingLengthSpread& spread) {
  const bool weighed = spread.flexural_rigidity > 0;
  return {{"face", face},
          {"readings", spread.readings},
          {"bending_length_m", spread.length},
          {"bending_length_variation", or_null(spread.length_variation)},
          {"flexural_rigidity_N_m", weighed ? Json(spread.flexural_rigidity) : Json(nullptr)},
          {"flexural_rigidity_variation",
           weighed ? or_null(spread.rigidity_variation) : Json(nullptr)}};
}

}  // namespace

StandardFigures standard_bending_length(const OverhangRows& rows, double angle, double weight) {
  Json faces = Json::array();
  for (const auto& [face, spread] : spread_by_face(rows, angle, weight)) {
    faces.push_back(spread_json(face, spread));
  }
  const double degrees = angle * 180 / std::numbers::pi;
  return {"bending_length",
          {{"angle_deg", degrees}, {"faces", faces}},
          fmt::format("at {:.4g} degrees", degrees),
          bending_length_texts(rows, angle, weight)};
}

}  // namespace pliant
