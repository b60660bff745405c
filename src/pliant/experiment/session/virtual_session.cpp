#include "pliant/experiment/session/virtual_session.h"

#include "pliant/base/assert.h"
#include "pliant/experiment/session/virtual/cut_sheet.h"
#include "pliant/experiment/session/virtual/observed_session.h"
#include "pliant/experiment/session/virtual/overhanging_sheet.h"
#include "pliant/experiment/session/virtual/pulled_sheet.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {

Session make_virtual_session(const Material& material, const VirtualSession& options,
                             RandomStream& random, const SessionWork& work) {
  PLIANT_ASSERT(material.density > 0, "a virtual sheet has weight");
  const CutSheet sheet = cut_sheet(options);
  const Material usable = held_beyond_range(material);
  Session session;
  session.test = options.test;
  session.info = {{"source", "virtual measurement of " + material.name}};
  session.rest = sheet.rest;
  session.sample.width = sheet.rest.positions.row(0).maxCoeff();
  session.sample.height = sheet.rest.positions.row(1).maxCoeff();
  session.sample.mass = material.density * rest_area(sheet.rest);
  if (session_test_kind(options.test).clip_mass > 0) {
    pull_sheet(sheet, usable, options, work, session);
  } else {
    push_over_edge(usable, options, work, session);
  }
  observe(options.noise, random, session);
  return session;
}

}  // namespace pliant
