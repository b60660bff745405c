#include "pliant/estimation/solid/solid_laws.h"

#include <algorithm>
#include <array>

#include "pliant/base/assert.h"
#include "pliant/material/addend/rubber_addends.h"

namespace pliant {
namespace {

using Components = std::map<std::string, ComponentModel>;

ComponentModel of(std::vector<const AddendKind*> addends) {
  return {CurveKind::none, FrictionChoice::none, std::move(addends)};
}

ComponentModel of(CurveKind stiffness) { return {stiffness, FrictionChoice::none, {}}; }

struct SolidLaw {
  std::string_view name;
  Components (*components)();
};

ComponentModel ogden(std::size_t terms) {
  return of(std::vector<const AddendKind*>(terms, &ogden_addend()));
}

const std::array kLaws{
    // The line on the stretches leaves their spline the second derivative alone; products of two
    // stretches, which no sum over single ones holds, are those of I2.
    SolidLaw{"additive",
             [] {
               ComponentModel stretches = of(CurveKind::spline);
               stretches.addends = {&linear_addend()};
               return Components{{"stretch-bar", stretches}, {"I2-bar", of({&linear_addend()})}};
             }},
    SolidLaw{"neo-hookean",
             [] {
               return Components{{"I1-bar", of({&linear_addend()})}};
             }},
    SolidLaw{
        "mooney-rivlin",
        [] {
          return Components{{"I1-bar", of({&linear_addend()})}, {"I2-bar", of({&linear_addend()})}};
        }},
    SolidLaw{"yeoh",
             [] {
               return Components{{"I1-bar", of({&polynomial_addend()})}};
             }},
    SolidLaw{"ogden-1",
             [] {
               return Components{{"stretch-bar", ogden(1)}};
             }},
    SolidLaw{"ogden-2",
             [] {
               return Components{{"stretch-bar", ogden(2)}};
             }},
    SolidLaw{"ogden-3",
             [] {
               return Components{{"stretch-bar", ogden(3)}};
             }},
    SolidLaw{"arruda-boyce",
             [] {
               return Components{{"I1-bar", of({&arruda_boyce_addend()})}};
             }},
    SolidLaw{"stvk",
             [] {
               return Components{{"trace", of(CurveKind::constant)},
                                 {"trace-of-square", of({&linear_addend()})}};
             }},
    SolidLaw{
        "orthotropic-stvk",
        [] {
          Components all;
          for (const char* own :
               {"green.xx", "green.yy", "green.zz", "green.yz", "green.xz", "green.xy"}) {
            all[own] = of(CurveKind::constant);
          }
          for (const char* pair : {"green.xx*green.yy", "green.yy*green.zz", "green.xx*green.zz"}) {
            all[pair] = of({&linear_addend()});
          }
          return all;
        }},
};

}  // namespace

std::vector<std::string_view> solid_laws() {
  std::vector<std::string_view> names;
  for (const SolidLaw& law : kLaws) names.push_back(law.name);
  return names;
}

Components solid_components(const ModelOptions& model, bool compressible) {
  if (!model.components.empty()) {
    Components stated = model.components;
    for (auto& [name, component] : stated) {
      if (component.friction)
        component.addends = addends_with_branches(component, *component.friction);
    }
    return stated;
  }
  const auto law = std::ranges::find(kLaws, model.solid_law, &SolidLaw::name);
  PLIANT_ASSERT(law != kLaws.end(), "a law that studies may ask for");
  Components components = law->components();
  const auto isochoric = [](const auto& component) { return component.first.ends_with("-bar"); };
  if (compressible && std::ranges::all_of(components, isochoric)) {
    components["J"] = of(CurveKind::constant);
  }
  return components;
}

}  // namespace pliant
