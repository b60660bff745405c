#include "pliant/study/stated_branches.h"

#include <string>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

void require_stated(const FrictionModel& friction, const FitSettings& settings,
                    const std::string& field) {
  if (friction.branches > 0) return;
  throw InputError({settings.file, 0, field},
                   "leaves the number of branches to the data, which fits of strips alone find",
                   "a number of them: dahl, dahl-2, dahl-3 or dahl-4");
}

}  // namespace

void require_stated_branches(const FitSettings& settings) {
  require_stated(settings.model.friction, settings, "model.friction");
  for (const auto& [name, component] : settings.model.components) {
    if (!component.friction) continue;
    require_stated(*component.friction, settings, "model.components." + name + ".friction");
  }
}

}  // namespace pliant
