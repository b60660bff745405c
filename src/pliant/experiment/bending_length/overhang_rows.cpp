#include "pliant/experiment/bending_length/overhang_rows.h"

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/experiment_data.h"

namespace pliant {
namespace {

constexpr int kDigits = 4;

StripFace face_of(const std::string& text, const DataRows& data, int row) {
  if (text == "1" || text == "top") return StripFace::up;
  if (text == "2" || text == "bottom") return StripFace::down;
  throw InputError(data.location(row, "face"), quoted_value(text) + " is no face",
                   "the face that lies up: 1 or 2, or top or bottom");
}

std::string variation_text(const std::optional<double>& variation) {
  return variation ? fmt::format(" (coefficient of variation {:.2g} %)", 100 * *variation) : "";
}

std::string spread_text(const std::string& face, const BendingLengthSpread& spread) {
  std::string text = fmt::format("{}, {} reading{}: bending length {}{}", face, spread.readings,
                                 spread.readings == 1 ? "" : "s",
                                 format_quantity(spread.length, Dimension::length, kDigits),
                                 variation_text(spread.length_variation));
  if (spread.flexural_rigidity > 0) {
    text += fmt::format(
        ", flexural rigidity {}{}",
        format_quantity(spread.flexural_rigidity, Dimension::bending_stiffness, kDigits),
        variation_text(spread.rigidity_variation));
  }
  return text;
}

}  // namespace

OverhangRows read_overhangs(const DataRows& data) {
  OverhangRows rows;
  rows.overhang = data.quantity("overhang", Dimension::length);
  require_positive(rows.overhang, data, "overhang");
  rows.face.assign(rows.overhang.size(), StripFace::up);
  if (const auto faces = data.optional_texts("face")) {
    for (size_t i = 0; i < faces->size(); ++i) {
      rows.face[i] = face_of((*faces)[i], data, static_cast<int>(i));
    }
  }
  data.optional_integers("repeat");
  return rows;
}

std::vector<double> overhangs_of(const OverhangRows& rows, StripFace face) {
  std::vector<double> overhangs;
  for (size_t i = 0; i < rows.face.size(); ++i) {
    if (rows.face[i] == face) overhangs.push_back(rows.overhang[i]);
  }
  return overhangs;
}

std::vector<FaceSpread> spread_by_face(const OverhangRows& rows, double angle, double weight) {
  std::vector<FaceSpread> faces;
  const auto add = [&](const char* face, const std::vector<double>& overhangs) {
    if (overhangs.empty()) return;
    const auto spread = bending_length_spread(overhangs, angle, weight);
    if (spread) faces.push_back({face, *spread});
  };
  const std::vector<double> up = overhangs_of(rows, StripFace::up);
  const std::vector<double> down = overhangs_of(rows, StripFace::down);
  add("1", up);
  add("2", down);
  if (!up.empty() && !down.empty()) add("both", rows.overhang);
  return faces;
}

std::vector<std::string> bending_length_texts(const OverhangRows& rows, double angle,
                                              double weight) {
  std::vector<std::string> texts;
  for (const auto& [face, spread] : spread_by_face(rows, angle, weight)) {
    texts.push_back(spread_text(face == "both" ? "both faces" : "face " + face, spread));
  }
  return texts;
}

}  // namespace pliant
