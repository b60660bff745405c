#include "pliant/experiment/sheet/make_predictor.h"

#include <algorithm>

#include "pliant/experiment/sheet/pushed_sheet.h"
#include "pliant/experiment/sheet/sheet_equilibria.h"
#include "pliant/experiment/sheet/sheet_path.h"

namespace pliant {

std::unique_ptr<SheetPredictor> make_predictor(const Session& session, const Material& material) {
  const auto has_friction = [&](const std::string& prefix) {
    return std::ranges::any_of(material.components, [&](const auto& component) {
      return component.first.starts_with(prefix) && component.second.friction.has_value();
    });
  };
  if (session.table && has_friction("bend.")) {
    return std::make_unique<PushedSheet>(session, material);
  }
  if (!session.table && has_friction("")) return std::make_unique<SheetPath>(session, material);
  return std::make_unique<SheetEquilibria>(session, material);
}

}  // namespace pliant
