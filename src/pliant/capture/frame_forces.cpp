#include "pliant/capture/frame_forces.h"

#include <algorithm>
#include <filesystem>

#include "pliant/capture/cell_forces.h"
#include "pliant/capture/tester_forces.h"
#include "pliant/measurement/session/cord_forces.h"

namespace pliant {
namespace {

/// Cords of a table.
class CordTableForces : public FrameForces {
 public:
  CordTableForces(const std::filesystem::path& table, const std::vector<SessionClip>& clips,
                  int frames) {
    const FrameRows rows(table, frames);
    FrameTimes times(frames);
    cords_ = read_cord_forces(rows, clips, frames, times).cords;
    for (const auto& time : times.increasing()) {
      if (time) log_.time.push_back(*time);
    }
    if (std::ssize(log_.time) < frames) log_.time.clear();
  }

  bool is_free(int frame) const override {
    return std::ranges::all_of(cords_[static_cast<std::size_t>(frame)],
                               [](const auto& cords) { return cords.empty(); });
  }

 private:
  std::string add_forces(SessionFrame& frame, std::size_t number,
                         const std::vector<HeldPlace>& /*held*/) const override {
    frame.cords = cords_[number];
    return {};
  }

  std::vector<std::vector<std::vector<CordForce>>> cords_;  // by frame and clip
};

}  // namespace

std::string FrameForces::add_to(SessionFrame& frame, int number,
                                const std::vector<HeldPlace>& held) const {
  const auto f = static_cast<std::size_t>(number);
  if (!log_.time.empty()) frame.time = log_.time[f];
  frame.cords.resize(held.size());
  return add_forces(frame, f, held);
}

std::unique_ptr<FrameForces> frame_forces(const DicFile& dic,
                                          const std::vector<SessionClip>& clips) {
  if (!dic.forces) return std::make_unique<FrameForces>();
  if (!dic.forces->cells.empty()) return std::make_unique<CellForces>(dic);
  if (dic.forces->cords)
    return std::make_unique<CordTableForces>(*dic.forces->cords, clips, dic.frame_count());
  return std::make_unique<TesterForces>(dic);
}

}  // namespace pliant
