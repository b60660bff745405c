#pragma once

#include "pliant/capture/logged_forces.h"

namespace pliant {

/// A tester's log: what it says pulls at one clip, and is answered by the other.
class TesterForces : public LoggedForces {
 public:
  explicit TesterForces(const DicFile& dic);

  bool needs_way() const override { return !rows_.extension.empty() && !dic().moves_by_log(); }
  std::vector<std::string> warnings(const std::vector<double>& ways) const override;

 private:
  Together together(const std::vector<double>& ways) const override;
  void place(double start) override;
  std::string add_forces(SessionFrame& frame, std::size_t number,
                         const std::vector<HeldPlace>& held) const override;

  FrameLog rows_;
};

}  // namespace pliant
