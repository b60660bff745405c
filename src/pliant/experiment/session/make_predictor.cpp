#include "pliant/experiment/session/make_predictor.h"

#include <algorithm>
#include <string>

#include "pliant/experiment/session/pushed_sheet.h"
#include "pliant/experiment/session/sheet_equilibria.h"
#include "pliant/experiment/session/sheet_path.h"

namespace pliant {

bool is_path(const Session& session, const Material& material) {
  const std::string shown = session.table ? "bend." : "";
  return std::ranges::any_of(material.components, [&](const auto& component) {
    return component.first.starts_with(shown) && component.second.stiffness &&
           law_of(component.second).remembers();
  });
}

std::unique_ptr<SheetPredictor> make_predictor(const Session& session, const Material& material) {
  if (!is_path(session, material)) return std::make_unique<SheetEquilibria>(session, material);
  if (session.table) return std::make_unique<PushedSheet>(session, material);
  return std::make_unique<SheetPath>(session, material);
}

}  // namespace pliant
