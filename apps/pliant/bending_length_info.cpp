#include "apps/pliant/bending_length_info.h"

#include <numbers>
#include <optional>

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

Json bending_length_json(const OverhangRows& rows, double angle, double weight) {
  Json faces = Json::array();
  for (const auto& [face, spread] : spread_by_face(rows, angle, weight)) {
    faces.push_back(spread_json(face, spread));
  }
  return {{"angle_deg", angle * 180 / std::numbers::pi}, {"faces", faces}};
}

}  // namespace pliant
