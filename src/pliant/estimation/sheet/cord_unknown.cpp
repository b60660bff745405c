#include "pliant/estimation/sheet/cord_unknown.h"

#include <fmt/format.h>

#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

std::string name_of(const SheetTest& test, const CordDrag& cord) {
  const SessionClip& clip = test.session().clips[static_cast<std::size_t>(cord.clip)];
  return fmt::format("{}.{}.{}.cord_friction", test.name(), clip.name, cord.cord);
}

}  // namespace

std::vector<SheetUnknown> cord_unknowns(const SheetTest& test) {
  std::vector<SheetUnknown> unknowns;
  if (!test.cord_friction().unknown) return unknowns;
  for (const CordDrag& cord : test.cords()) {
    SheetUnknown unknown;
    unknown.name = name_of(test, cord);
    unknown.owner = test.name();
    unknown.clip = test.session().clips[static_cast<std::size_t>(cord.clip)].name;
    unknown.unit = std::string(1, 'N');
    unknown.upper = kNoLimit;
    unknown.scale = kCordFriction;
    unknown.prior = GaussianPrior{0, kCordFriction};
    unknowns.push_back(std::move(unknown));
  }
  return unknowns;
}

Eigen::VectorXd cord_widths(const SheetTest& test, const CordFrictions& found) {
  const std::vector<CordDrag>& cords = test.cords();
  Eigen::VectorXd widths(static_cast<Eigen::Index>(cords.size()));
  for (std::size_t i = 0; i < cords.size(); ++i) {
    const auto known = found.find(name_of(test, cords[i]));
    widths(static_cast<Eigen::Index>(i)) =
        known == found.end() ? test.cord_friction().width : known->second;
  }
  return widths;
}

}  // namespace pliant
