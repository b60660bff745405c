#include "pliant/measurement/session.h"

#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/io/result_directory.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/clip_poses.h"
#include "pliant/measurement/session/cord_checks.h"
#include "pliant/measurement/session/cord_forces.h"
#include "pliant/measurement/session/sample_checks.h"
#include "pliant/measurement/session/session_document.h"
#include "pliant/measurement/session/sheet_files.h"
#include "pliant/measurement/session/table_edges.h"
#include "pliant/measurement/session/unseen_vertices.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// The clips with the vertices that they clamp, each of which is in one clip.
std::vector<SessionClip> resolved_clips(const std::vector<ClipEntry>& entries, int vertices) {
  std::vector<const ClipEntry*> holder(static_cast<std::size_t>(vertices), nullptr);
  std::vector<SessionClip> clips;
  for (const ClipEntry& entry : entries) {
    clips.push_back({entry.name, entry.mass, numbers_of(entry.clamped, vertices, "vertex")});
    for (const int vertex : clips.back().clamped) {
      const ClipEntry*& held_by = holder[static_cast<std::size_t>(vertex)];
      if (held_by != nullptr) {
        throw InputError(entry.clamped.where,
                         held_by == &entry ? fmt::format("vertex {} is listed twice in clip {}",
                                                         vertex, entry.name)
                                           : fmt::format("vertex {} is in the clips {} and {}",
                                                         vertex, held_by->name, entry.name),
                         "each vertex in one clip, once");
      }
      held_by = &entry;
    }
  }
  return clips;
}

Session begin_session(const SessionDocument& document) {
  Session session;
  session.kind = document.kind;
  session.test = document.test;
  session.info = document.info;
  session.sample = document.sample;
  session.gravity = document.gravity;
  session.balance_bound = document.balance_bound;
  session.noise = document.noise;
  if (document.table) session.table = document.table->axis;
  return session;
}

void add_warnings(std::vector<std::string> more, std::vector<std::string>& warnings) {
  std::move(more.begin(), more.end(), std::back_inserter(warnings));
}

/// The tables of a session; its frames get what they say.
class TableReader {
 public:
  TableReader(const fs::path& directory, const SessionDocument& document, Session& session)
      : directory_(directory), document_(document), session_(session), times_(frames()) {}

  void read() {
    read_clips();
    if (document_.table) {
      read_table();
    } else if (fs::exists(directory_ / "table.csv")) {
      session_.warnings.push_back("table.csv is not used: session.yaml has no `table`");
    }
    // Clips and table tell where they hold the sheet; cords are compared with the whole of it.
    add_warnings(fill_in_unseen(session_, document_.frames), session_.warnings);
    read_cords();
    const std::vector<std::optional<double>> times = times_.increasing();
    for (std::size_t f = 0; f < times.size(); ++f) session_.frames[f].time = times[f];
  }

 private:
  int frames() const { return session_.frame_count(); }

  FrameRows rows_of(const char* name) const { return {directory_ / name, frames()}; }

  void warn_of_unused(const FrameRows& rows) {
    if (const auto unused = rows.unused()) session_.warnings.push_back(*unused);
  }

  void read_clips() {
    const FrameRows rows = rows_of("clips.csv");
    const ClipPoses poses = read_clip_poses(rows, session_.clips, frames(), times_);
    for (std::size_t f = 0; f < session_.frames.size(); ++f) {
      session_.frames[f].poses = poses.poses[f];
    }
    require_clamped_vertices(session_, poses);
    warn_of_unused(rows);
  }

  void read_cords() {
    const FrameRows rows = rows_of("cords.csv");
    const CordForces cords = read_cord_forces(rows, session_.clips, frames(), times_);
    for (std::size_t f = 0; f < session_.frames.size(); ++f) {
      session_.frames[f].cords = cords.cords[f];
    }
    require_attached_cords(session_, cords);
    warn_of_unused(rows);
  }

  void read_table() {
    const FrameRows rows = rows_of("table.csv");
    const std::vector<double> edges =
        read_table_edges(rows, *document_.table, session_.rest, frames(), times_);
    for (std::size_t f = 0; f < edges.size(); ++f) session_.frames[f].table_edge = edges[f];
    warn_of_unused(rows);
  }

  const fs::path& directory_;
  const SessionDocument& document_;
  Session& session_;
  FrameTimes times_;
};

/// What `session_files` relies on; what `read_session` gives has it.
void check_shape(const Session& session) {
  PLIANT_ASSERT(!session.frames.empty(), "a session has frames");
  for (const SessionFrame& frame : session.frames) {
    PLIANT_ASSERT(frame.positions.cols() == session.rest.vertex_count(),
                  "a frame has a position for each vertex");
    PLIANT_ASSERT(frame.poses.size() == session.clips.size(), "a frame has a pose of each clip");
    PLIANT_ASSERT(frame.cords.size() == session.clips.size(), "a frame has cords of each clip");
    PLIANT_ASSERT(frame.table_edge.has_value() == session.table.has_value(),
                  "a frame has a table's edge where there is a table");
  }
}

}  // namespace

Eigen::Vector3d clip_middle(const Session& session, int frame, int clip) {
  const std::vector<int>& clamped = session.clips[static_cast<std::size_t>(clip)].clamped;
  return session.frames[static_cast<std::size_t>(frame)]
      .positions(Eigen::all, clamped)
      .rowwise()
      .mean();
}

Session with_frames(const Session& session, const std::vector<int>& frames) {
  Session result = session;
  result.frames.clear();
  for (const int frame : frames) {
    result.frames.push_back(session.frames[static_cast<std::size_t>(frame)]);
  }
  return result;
}

Session read_session(const fs::path& directory) {
  const SessionDocument document = read_session_document(directory / "session.yaml");
  Session session = begin_session(document);
  const RestSheet rest = read_rest_sheet(document.rest, document.sample);
  session.rest = rest.mesh;
  session.clips = resolved_clips(document.clips, session.rest.vertex_count());
  session.frames.resize(static_cast<std::size_t>(document.frames.count()));
  for (int f = 0; f < session.frame_count(); ++f) {
    FrameSheet sheet = read_frame_sheet(document.frames.file(f), f, rest);
    SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    frame.positions = std::move(sheet.positions);
    frame.deviations = std::move(sheet.deviations);
  }
  TableReader(directory, document, session).read();
  for (const auto judge :
       {sample_warnings, outlier_warnings, cord_warnings, balance_warnings, table_warnings}) {
    add_warnings(judge(session), session.warnings);
  }
  session.questions = sample_questions(session);
  return session;
}

void make_session_files(const Session& session,
                        const std::function<void(const std::string&, std::string)>& take) {
  check_shape(session);
  take("rest.ply", sheet_ply(session.rest, session.rest.positions));
  for (int f = 0; f < session.frame_count(); ++f) {
    const SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    take(fmt::format("frames/{:04}.ply", f),
         sheet_ply(session.rest, frame.positions, frame.unseen, frame.deviations));
  }
  take("clips.csv", clip_pose_table(session));
  take("cords.csv", cord_force_table(session));
  if (session.table) take("table.csv", table_edge_table(session));
  take("session.yaml", session_document_text(session));
}

std::vector<std::pair<std::string, std::string>> session_files(const Session& session) {
  std::vector<std::pair<std::string, std::string>> files;
  make_session_files(session, [&](const std::string& name, std::string content) {
    files.emplace_back(name, std::move(content));
  });
  return files;
}

void write_session(const fs::path& directory, const Session& session, const std::string& command) {
  ResultDirectory results(directory, command);
  make_session_files(session, [&](const std::string& name, const std::string& content) {
    results.write(name, content);
  });
  results.commit();
}

}  // namespace pliant
