#include "pliant/measurement/session/cord_forces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

void require_new(const std::vector<CordForce>& cords, const std::string& cord,
                 const std::string& clip, int frame, const Location& where) {
  const bool known = std::any_of(cords.begin(), cords.end(),
                                 [&](const CordForce& other) { return other.cord == cord; });
  if (!known) return;
  throw InputError(where,
                   fmt::format("frame {}, clip {}: a second row of the cord {}", frame, clip,
                               quoted_value(cord)),
                   "each cord once in a frame");
}

/// Without names the same row twice is a cord that counts twice.
void require_other_row(const std::vector<CordForce>& cords, const CordForce& cord,
                       const std::string& clip, int frame, const Location& where) {
  const bool known = std::any_of(cords.begin(), cords.end(), [&](const CordForce& other) {
    return other.point == cord.point && other.force == cord.force;
  });
  if (!known) return;
  throw InputError(where, fmt::format("frame {}, clip {}: the same row twice", frame, clip),
                   "each cord once in a frame");
}

void require_pull(const CordForce& cord, const std::string& clip, int frame,
                  const Location& where) {
  if (cord.force.cwiseAbs().maxCoeff() <= kHardestPull) return;
  throw InputError(where,
                   fmt::format("frame {}, clip {}: a force of {:.3g} N", frame, clip,
                               cord.force.cwiseAbs().maxCoeff()),
                   "newtons");
}

bool has_cords(const SessionFrame& frame) {
  return std::any_of(frame.cords.begin(), frame.cords.end(),
                     [](const std::vector<CordForce>& cords) { return !cords.empty(); });
}

bool any_cord_has_a_name(const Session& session) {
  for (const SessionFrame& frame : session.frames) {
    for (const std::vector<CordForce>& cords : frame.cords) {
      for (const CordForce& cord : cords) {
        if (!cord.cord.empty()) return true;
      }
    }
  }
  return false;
}

}  // namespace

CordForces read_cord_forces(const FrameRows& rows, const std::vector<SessionClip>& clips,
                            int frames, FrameTimes& times) {
  const CsvTable& table = rows.table();
  const std::vector<int> clip_of = rows.clips(clips);
  std::array<std::vector<double>, 6> columns;
  constexpr std::array kNames{"px", "py", "pz", "fx", "fy", "fz"};
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = table.numbers(kNames[i]);
  const bool named = table.has("cord");
  const std::vector<std::string> names =
      named ? table.texts("cord") : std::vector<std::string>(table.rows());

  CordForces result;
  result.file = table.file();
  result.cords.resize(static_cast<std::size_t>(frames));
  result.lines.resize(static_cast<std::size_t>(frames));
  for (auto& cords : result.cords) cords.resize(clips.size());
  for (auto& lines : result.lines) lines.resize(clips.size());
  for (int row = 0; row < rows.rows(); ++row) {
    const auto r = static_cast<std::size_t>(row);
    const auto frame = static_cast<std::size_t>(rows.frame(row));
    const auto clip = static_cast<std::size_t>(clip_of[r]);
    std::vector<CordForce>& cords = result.cords[frame][clip];
    if (named && !names[r].empty()) {
      require_new(cords, names[r], clips[clip].name, rows.frame(row), rows.location(row, "cord"));
    }
    const CordForce cord{names[r],
                         {columns[0][r], columns[1][r], columns[2][r]},
                         {columns[3][r], columns[4][r], columns[5][r]}};
    require_pull(cord, clips[clip].name, rows.frame(row), rows.location(row, "fx"));
    if (names[r].empty()) {
      require_other_row(cords, cord, clips[clip].name, rows.frame(row), rows.location(row, "clip"));
    }
    cords.push_back(cord);
    result.lines[frame][clip].push_back(rows.location(row, "cord").line);
  }
  times.take(rows);
  return result;
}

void require_attached_cords(const Session& session, const CordForces& cords) {
  const double most = kCordReach * std::hypot(session.sample.width, session.sample.height);
  for (std::size_t f = 0; f < session.frames.size(); ++f) {
    const SessionFrame& frame = session.frames[f];
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      const SessionClip& clip = session.clips[c];
      const Eigen::Vector3d middle = clip_middle(session, static_cast<int>(f), static_cast<int>(c));
      for (std::size_t i = 0; i < frame.cords[c].size(); ++i) {
        const double distance = (frame.cords[c][i].point - middle).norm();
        if (distance <= most) continue;
        throw InputError({cords.file, cords.lines[f][c][i], "px"},
                         fmt::format("frame {}, clip {}: a cord is attached {} from the clip", f,
                                     clip.name, format_quantity(distance, Dimension::length)),
                         fmt::format("a point in metres, in the axes of the frames, within {}",
                                     format_quantity(most, Dimension::length)));
      }
    }
  }
}

std::string cord_force_table(const Session& session) {
  const bool named = any_cord_has_a_name(session);
  const bool timed = all_rows_timed(session, has_cords);
  std::vector<std::string> header{"frame", "clip", "px", "py", "pz", "fx", "fy", "fz"};
  if (named) header.emplace_back("cord");
  if (timed) header.emplace_back("time_s");
  CsvWriter writer(header);
  for (int f = 0; f < session.frame_count(); ++f) {
    const SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      for (const CordForce& cord : frame.cords[c]) {
        writer.cell(f).cell(session.clips[c].name);
        for (const double number : cord.point) writer.cell(number);
        for (const double number : cord.force) writer.cell(number);
        if (named) writer.cell(cord.cord);
        if (timed) writer.cell(*frame.time);
        writer.end_row();
      }
    }
  }
  return writer.text();
}

}  // namespace pliant
