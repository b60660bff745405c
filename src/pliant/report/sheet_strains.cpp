#include "pliant/report/sheet_strains.h"

#include "pliant/experiment/session/sheet_system.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant::report {

std::vector<double> sheet_strains(const Session& session, const Material& material,
                                  const std::string& component) {
  const SheetSystem system(session, held_beyond_range(material), {}, {});
  std::vector<double> all;
  for (const SessionFrame& frame : session.frames) {
    const std::vector<double> strains = system.strains(component, frame.positions);
    all.insert(all.end(), strains.begin(), strains.end());
  }
  return all;
}

}  // namespace pliant::report
