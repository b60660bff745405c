#include "pliant/report/sheet_session.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/geometry/topology.h"
#include "pliant/io/csv.h"
#include "pliant/report/numbers_or_none.h"

namespace pliant::report {
namespace {

void require_alike(const SheetSession& sheet, const std::filesystem::path& folder) {
  const bool alike =
      sheet.measured.frame_count() == sheet.predicted.frame_count() &&
      same_triangles(sheet.measured.rest.triangles, sheet.predicted.rest.triangles) &&
      std::ranges::equal(sheet.measured.clips, sheet.predicted.clips, {}, &SessionClip::clamped,
                         &SessionClip::clamped);
  if (alike) return;
  throw InputError({(folder / "predicted").string(), 0, {}}, "is not of the session in measured",
                   "the same frames, clips and mesh");
}

/// Sums of squares over the free nodes of a frame.
struct Squares {
  double sum = 0;
  Eigen::Index nodes = 0;

  void add(const SheetSession& sheet, int frame) {
    const std::vector<int> free = free_nodes(sheet.measured, frame);
    sum += position_residual(sheet, frame)(Eigen::all, free).squaredNorm();
    nodes += std::ssize(free);
  }
  double rms() const { return nodes > 0 ? std::sqrt(sum / static_cast<double>(nodes)) : 0; }
};

/// The nodes whose places tell how far a sheet was taken: a sheet that hangs through between clips
/// is not far from flat where they are at rest.
std::vector<int> telling_nodes(const Session& session) {
  std::vector<int> nodes;
  for (const SessionClip& clip : session.clips) {
    nodes.insert(nodes.end(), clip.clamped.begin(), clip.clamped.end());
  }
  if (!nodes.empty()) return nodes;
  nodes.resize(static_cast<std::size_t>(session.rest.vertex_count()));
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

double distortion(const Eigen::Matrix3Xd& rest, const Eigen::Matrix3Xd& now) {
  const Eigen::Matrix4d rigid = Eigen::umeyama(rest, now, /*with_scaling=*/false);
  const Eigen::Matrix3Xd moved =
      (rigid.topLeftCorner<3, 3>() * rest).colwise() + rigid.topRightCorner<3, 1>();
  return (now - moved).norm();
}

}  // namespace

SheetSession read_sheet_session(const std::filesystem::path& folder) {
  SheetSession sheet{read_session(folder / "measured"), read_session(folder / "predicted")};
  require_alike(sheet, folder);
  return sheet;
}

std::vector<int> free_nodes(const Session& session, int frame) {
  const SessionFrame& now = session.frames[static_cast<std::size_t>(frame)];
  const std::vector<int> held = held_nodes(session, now.table_edge);
  std::vector<int> free;
  for (int node = 0; node < session.rest.vertex_count(); ++node) {
    if (std::ranges::binary_search(held, node)) continue;
    if (!std::ranges::binary_search(now.unseen, node)) free.push_back(node);
  }
  return free;
}

Eigen::Matrix3Xd position_residual(const SheetSession& sheet, int frame) {
  const auto f = static_cast<std::size_t>(frame);
  return sheet.predicted.frames[f].positions - sheet.measured.frames[f].positions;
}

double rms_distance(const SheetSession& sheet, int frame) {
  Squares squares;
  squares.add(sheet, frame);
  return squares.rms();
}

double rms_distance(const SheetSession& sheet) {
  Squares squares;
  for (int frame = 0; frame < sheet.frame_count(); ++frame) squares.add(sheet, frame);
  return squares.rms();
}

int most_distorted_frame(const Session& session) {
  const std::vector<int> nodes = telling_nodes(session);
  const Eigen::Matrix3Xd rest = session.rest.positions(Eigen::all, nodes);
  int most = 0;
  double largest = -1;
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    const auto& positions = session.frames[static_cast<std::size_t>(frame)].positions;
    const double found = distortion(rest, positions(Eigen::all, nodes));
    if (found > largest) {
      largest = found;
      most = frame;
    }
  }
  return most;
}

double rms_clip_force(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file, CsvOptions{});
  const std::vector<double> measured = table.numbers("measured_force_N");
  const std::vector<double> predicted = numbers_or_none(table, "predicted_force_N");
  const std::vector<long> frame = table.integers("frame");
  const std::vector<std::string> clip = table.texts("clip");
  std::set<std::pair<long, std::string>> forces;
  double squares = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isnan(predicted[row])) continue;
    squares += std::pow(predicted[row] - measured[row], 2);
    forces.insert({frame[row], clip[row]});
  }
  return forces.empty() ? 0 : std::sqrt(squares / static_cast<double>(forces.size()));
}

}  // namespace pliant::report
