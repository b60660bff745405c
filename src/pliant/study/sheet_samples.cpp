#include "pliant/study/sheet_samples.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"

namespace pliant {
namespace {

/// What differs from place to place is elastic.
void refuse_memory(const FitSettings& settings) {
  if (settings.model.friction.choice == FrictionChoice::dahl) {
    throw InputError(
        {settings.file, 0, "model.friction"},
        "is `dahl`, and the model has samples, which are elastic",
        "`auto` or `none`, and `dahl` under `components` of what is the same everywhere");
  }
  for (const auto& [name, component] : settings.model.components) {
    const bool remembers_more = std::ranges::any_of(
        component.addends, [](const AddendKind* kind) { return remembers(*kind); });
    if (!may_differ(settings, {name})) continue;
    const bool rubs = component.friction && component.friction->choice == FrictionChoice::dahl;
    if (!rubs && !remembers_more) continue;
    throw InputError({settings.file, 0, "model.components." + name},
                     "has friction or another law that remembers, and differs from place to place",
                     "`samples.of` without it, or a component that is elastic");
  }
}

/// Places by hand lie within the sheet, each once.
void require_places(const SampleOptions& options, const TriangleMesh& sheet) {
  const Eigen::Vector2d low = sheet.rest_corners.rowwise().minCoeff(),
                        high = sheet.rest_corners.rowwise().maxCoeff();
  for (std::size_t k = 0; k < options.places.size(); ++k) {
    const Eigen::Vector2d place = options.places[k].head<2>();
    if ((place.array() < low.array()).any() || (place.array() > high.array()).any()) {
      throw InputError(options.where, fmt::format("sample {} lies outside the sheet", k),
                       "places in its rest plane (m)");
    }
    const auto own = options.places.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::find(options.places.begin(), own, *own) != own) {
      throw InputError(options.where, fmt::format("sample {} is a second one at its place", k),
                       "each place once");
    }
  }
}

/// What differs is fitted.
void require_fitted(const SampleOptions& options, const std::vector<SheetStage>& plan) {
  std::vector<std::string> fitted;
  for (const ComponentGroup& group : groups_of(plan)) {
    fitted.insert(fitted.end(), group.begin(), group.end());
  }
  for (const std::string& name : options.of) {
    if (std::ranges::find(fitted, name) != fitted.end()) continue;
    throw InputError(options.where, quoted_value(name) + " is fitted by no stage",
                     list_of_names(fitted));
  }
}

/// Samples lie in the rest plane of one sheet.
void require_one_sheet(const FitSettings& settings, const std::vector<const SheetTest*>& tests) {
  constexpr double kAlike = 0.02;
  const SessionSample& first = tests.front()->session().sample;
  for (const SheetTest* test : tests) {
    const SessionSample& sample = test->session().sample;
    const bool alike = std::abs(sample.width - first.width) < kAlike * first.width &&
                       std::abs(sample.height - first.height) < kAlike * first.height;
    if (alike) continue;
    throw InputError(settings.model.samples->where,
                     fmt::format("stands beside sheets of several sizes: {} and {}",
                                 tests.front()->name(), test->name()),
                     "sessions of one sheet");
  }
}

}  // namespace

void require_samples_of_sheet(const FitSettings& settings,
                              const std::vector<const SheetTest*>& tests,
                              const std::vector<SheetStage>& plan) {
  if (!settings.model.samples) return;
  refuse_memory(settings);
  require_one_sheet(settings, tests);
  require_places(*settings.model.samples, tests.front()->session().rest);
  require_fitted(*settings.model.samples, plan);
}

}  // namespace pliant
