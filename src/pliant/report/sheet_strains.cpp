#include "pliant/report/sheet_strains.h"

#include "pliant/experiment/sheet/sheet_system.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant::report {
namespace {

void add_strains(const Session& session, const Material& material,
                 std::vector<ComponentStrains>& all) {
  const SheetSystem system(session, material, {}, {});
  for (ComponentStrains& component : all) {
    for (const SessionFrame& frame : session.frames) {
      const std::vector<double> strains = system.strains(component.component, frame.positions);
      component.strains.insert(component.strains.end(), strains.begin(), strains.end());
    }
  }
}

}  // namespace

std::vector<ComponentStrains> sheet_strains(const std::vector<const Session*>& sessions,
                                            const Material& material) {
  const Material usable = held_beyond_range(material);
  std::vector<ComponentStrains> all;
  for (const auto& [name, component] : usable.components) all.push_back({name, {}});
  for (const Session* session : sessions) add_strains(*session, usable, all);
  return all;
}

}  // namespace pliant::report
