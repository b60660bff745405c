#include "pliant/estimation/sheet/sheet_plan.h"

#include <algorithm>

#include "pliant/base/add_once.h"
#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/estimation/sheet/first_laws.h"
#include "pliant/measurement/session/frame_measures.h"

namespace pliant {
namespace {

using Tests = std::vector<const SheetTest*>;

/// How often what clips pull and bending, which have a little influence on each other, are fitted
/// again.
constexpr int kPassesAgain = 2;

Tests named(const Tests& tests, const std::vector<std::string>& names) {
  Tests found;
  for (const SheetTest* test : tests) {
    if (std::ranges::find(names, test->session().test) != names.end()) found.push_back(test);
  }
  return found;
}

/// Weft and warp are one group where the material is the same in both.
std::vector<ComponentGroup> grouped(const std::vector<std::string>& components, bool isotropic) {
  std::vector<ComponentGroup> groups;
  const auto has = [&](const std::string& name) {
    return std::ranges::find(components, name) != components.end();
  };
  for (const std::string& component : components) {
    const bool weft = component.ends_with(".weft"), warp = component.ends_with(".warp");
    if (!isotropic || !(weft || warp) || is_sheet_pair(component)) {
      groups.push_back({component});
      continue;
    }
    const std::string family = component.substr(0, component.find('.'));
    if (warp && has(family + ".weft")) continue;
    groups.push_back({family + ".weft", family + ".warp"});
  }
  return groups;
}

void add_stage(const std::vector<std::string>& components, const Tests& tests, bool isotropic,
               StageKind kind, std::vector<SheetStage>& plan) {
  if (tests.empty()) return;
  plan.push_back({grouped(components, isotropic), tests, kind});
}

std::vector<SheetStage> plan_of_thesis(const FitSettings& settings, const Tests& tests) {
  const bool isotropic = settings.model.isotropic;
  const bool springs_bend = settings.model.bending == "spring";
  const Tests shear =
      !named(tests, {"shear"}).empty() ? named(tests, {"shear"}) : named(tests, {"bias-extension"});
  const Tests weft = named(tests, {"bend-weft"}), warp = named(tests, {"bend-warp"});
  const Tests bending = named(tests, {"bend-weft", "bend-warp"});
  std::vector<SheetStage> plan;
  const auto add = [&](const std::vector<std::string>& components, const Tests& data,
                       StageKind kind) { add_stage(components, data, isotropic, kind, plan); };
  std::vector<std::string> bends;
  if (!weft.empty()) bends.emplace_back("bend.weft");
  if (!warp.empty()) bends.emplace_back("bend.warp");
  bends.emplace_back("bend.diagonal");
  const auto add_bending = [&](StageKind kind) {
    if (isotropic) {
      add({"bend.weft", "bend.warp"}, bending, kind);
    } else {
      add({"bend.weft"}, weft, kind);
      add({"bend.warp"}, warp, kind);
    }
    add({"bend.diagonal"}, bending, kind);
  };
  const auto add_stretch = [&](StageKind kind) {
    if (isotropic) {
      add({"stretch.weft", "stretch.warp"}, named(tests, {"stretch-weft", "stretch-warp"}), kind);
    } else {
      add({"stretch.weft"}, named(tests, {"stretch-weft"}), kind);
      add({"stretch.warp"}, named(tests, {"stretch-warp"}), kind);
    }
  };
  add_stretch(StageKind::grow);
  add({"shear"}, shear, StageKind::grow);
  ComponentGroup of_triangles{"stretch.weft", "stretch.warp", "shear"};
  const std::vector<std::string> metrics = asked_metrics(settings);
  const Tests pulled = named(tests, {"stretch-weft", "stretch-warp", "shear", "bias-extension"});
  for (const std::string& component : metrics) {
    of_triangles.push_back(component);
    add({component}, pulled, StageKind::grow);
    add(of_triangles, pulled, StageKind::again);
  }
  if (!settings.model.limits.empty()) add(of_triangles, pulled, StageKind::limit);
  add_bending(StageKind::constant);
  add(bends, bending, StageKind::again);
  add_bending(StageKind::grow);
  for (int pass = 0; pass < kPassesAgain; ++pass) {
    add(bends, bending, StageKind::again);
    if (springs_bend && !bending.empty()) add_stretch(StageKind::again);
    if (bending.empty()) continue;
    if (metrics.empty() && settings.model.limits.empty()) {
      add({"shear"}, shear, StageKind::again);
    } else {
      add(of_triangles, pulled, StageKind::again);
    }
  }
  return plan;
}

/// After the stages of a study limits of energies of triangles, beside all curves of theirs and
/// from all tests that tell those.
void add_limits(const FitSettings& settings, std::vector<SheetStage>& plan) {
  if (settings.model.limits.empty() || settings.fit.plan.empty()) return;
  SheetStage limits{{}, {}, StageKind::limit};
  for (const SheetStage& stage : plan) {
    if (is_bending(stage.groups.front().front())) continue;
    for (const ComponentGroup& group : stage.groups) add_once(group, limits.groups);
    for (const SheetTest* test : stage.tests) add_once(test, limits.tests);
  }
  if (!limits.tests.empty()) plan.push_back(std::move(limits));
}

/// After all other curves those that differ from place to place, beside those of triangles.
void add_samples(const FitSettings& settings, std::vector<SheetStage>& plan) {
  if (!settings.model.samples) return;
  SheetStage samples{{}, {}, StageKind::sample};
  for (const SheetStage& stage : plan) {
    for (const ComponentGroup& group : stage.groups) {
      if (is_bending(group.front()) && !may_differ(settings, group)) continue;
      add_once(group, samples.groups);
      for (const SheetTest* test : stage.tests) add_once(test, samples.tests);
    }
  }
  plan.push_back(std::move(samples));
}

/// Friction and addends that remember of what is pulled by clips, from sequences that return, where
/// the study does not say no.
void add_friction(const FitSettings& settings, std::vector<SheetStage>& plan) {
  std::vector<SheetStage> stages;
  for (const ComponentGroup& group : groups_of(plan)) {
    const bool remembers_more = std::ranges::any_of(
        model_of(settings, group).addends, [](const AddendKind* kind) { return remembers(*kind); });
    if (is_bending(group.front()) || is_sheet_pair(group.front())) continue;
    if (may_differ(settings, group)) continue;
    if (!asks_for_friction(settings, group) && !remembers_more) continue;
    Tests data;
    for (const SheetStage& stage : plan) {
      if (stage.groups == std::vector<ComponentGroup>{group}) data = stage.tests;
    }
    std::erase_if(data, [](const SheetTest* test) {
      return test->session().table || !returns(test->session());
    });
    if (!data.empty()) stages.push_back({{group}, data, StageKind::friction});
  }
  plan.insert(plan.end(), stages.begin(), stages.end());
}

/// Friction of bending from what hangs over a table's edge, of all directions together that the
/// study asks for it: they bend at once, and each search follows whole paths.
void add_bending_friction(const FitSettings& settings, std::vector<SheetStage>& plan) {
  SheetStage friction{{}, {}, StageKind::friction};
  for (const SheetStage& stage : plan) {
    for (const ComponentGroup& group : stage.groups) {
      if (!is_bending(group.front()) || !states_friction(settings, group)) continue;
      add_once(group, friction.groups);
      for (const SheetTest* test : stage.tests) {
        if (test->session().table) add_once(test, friction.tests);
      }
    }
  }
  if (!friction.tests.empty()) plan.push_back(std::move(friction));
}

/// The tests that a stage of a study names.
Tests tests_named_by(const PlanStage& stage, const Tests& tests) {
  const auto is_called = [](const SheetTest* test, const std::string& pattern) {
    return matches(pattern, test->name());
  };
  for (const std::string& pattern : stage.experiments) {
    if (std::ranges::any_of(tests, [&](const auto* test) { return is_called(test, pattern); })) {
      continue;
    }
    throw InputError(stage.where, quoted_value(pattern) + " matches no session that is fitted",
                     "a name or a pattern with *");
  }
  Tests own;
  for (const SheetTest* test : tests) {
    const auto names_it = [&](const std::string& pattern) { return is_called(test, pattern); };
    if (std::ranges::any_of(stage.experiments, names_it)) own.push_back(test);
  }
  return own;
}

/// Terms of two strains are named by the model; other components every sheet may have.
void require_pairs(const PlanStage& stage, const ModelOptions& model) {
  for (const std::string& component : stage.components) {
    if (!is_sheet_pair(component) || model.components.contains(component)) continue;
    throw InputError(stage.where, quoted_value(component) + " is no component of the model",
                     "a term under `model.components`");
  }
}

std::vector<SheetStage> plan_of_study(const FitSettings& settings, const Tests& tests,
                                      bool isotropic) {
  std::vector<SheetStage> plan;
  std::vector<std::string> seen;
  for (const PlanStage& asked : settings.fit.plan) {
    require_pairs(asked, settings.model);
    const Tests data = tests_named_by(asked, tests);
    const bool again = std::ranges::all_of(asked.components, [&](const std::string& component) {
      return std::ranges::find(seen, component) != seen.end();
    });
    seen.insert(seen.end(), asked.components.begin(), asked.components.end());
    const bool grows = !again && grouped(asked.components, isotropic).size() == 1;
    add_stage(asked.components, data, isotropic, grows ? StageKind::grow : StageKind::again, plan);
  }
  return plan;
}

void leave_out(const std::vector<std::string>& known, std::vector<SheetStage>& plan) {
  const auto is_known = [&](const ComponentGroup& group) {
    return std::ranges::any_of(group, [&](const std::string& component) {
      return std::ranges::find(known, component) != known.end();
    });
  };
  for (SheetStage& stage : plan) {
    if (std::ranges::all_of(stage.groups, is_known)) stage.kind = StageKind::hold;
    if (stage.kind != StageKind::hold) std::erase_if(stage.groups, is_known);
  }
}

}  // namespace

std::vector<SheetStage> sheet_plan(const FitSettings& settings,
                                   const std::vector<const SheetTest*>& tests,
                                   const std::vector<std::string>& known) {
  const bool isotropic = settings.model.isotropic;
  std::vector<SheetStage> plan = settings.fit.plan.empty()
                                     ? plan_of_thesis(settings, tests)
                                     : plan_of_study(settings, tests, isotropic);
  if (plan.empty()) {
    throw InputError({settings.file, 0, "experiments"},
                     "the plan of the fit has no stage for the sessions to be fitted",
                     "sessions of the tests stretch-weft, stretch-warp, shear, bias-extension, "
                     "bend-weft, bend-warp, or a plan under fit");
  }
  add_limits(settings, plan);
  add_samples(settings, plan);
  add_friction(settings, plan);
  add_bending_friction(settings, plan);
  leave_out(known, plan);
  return plan;
}

bool may_differ(const FitSettings& settings, const ComponentGroup& group) {
  return settings.model.samples && std::ranges::any_of(group, [&](const std::string& component) {
           return settings.model.samples->differ_in(component);
         });
}

std::vector<const SheetTest*> tests_of(const std::vector<SheetStage>& plan) {
  std::vector<const SheetTest*> tests;
  for (const SheetStage& stage : plan) {
    for (const SheetTest* test : stage.tests) add_once(test, tests);
  }
  return tests;
}

std::vector<ComponentGroup> groups_of(const std::vector<SheetStage>& plan) {
  std::vector<ComponentGroup> groups;
  for (const SheetStage& stage : plan) {
    for (const ComponentGroup& group : stage.groups) {
      if (std::ranges::find(groups, group) == groups.end()) groups.push_back(group);
    }
  }
  return groups;
}

}  // namespace pliant
