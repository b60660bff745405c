#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/index_list.h"
#include "pliant/measurement/session.h"
#include "pliant/measurement/session/frame_names.h"

namespace pliant {

/// A clip as session.yaml describes it.
struct ClipEntry {
  std::string name;
  double mass = 0;  ///< kg
  IndexList clamped;
};

/// `table` of session.yaml.
struct TableEntry {
  RestAxis axis = RestAxis::u;
  double edge = 0;  ///< in frame 0 (m)
  Location where;
};

/// Content of session.yaml; the files that it names are not read.
struct SessionDocument {
  SessionKind kind = SessionKind::sheet;
  std::string test;
  std::map<std::string, std::string> info;
  SessionSample sample;
  Location sample_where;
  Eigen::Vector3d gravity{0, 0, -kStandardGravity};  ///< m/s^2
  double balance_bound = kCordFriction;              ///< N
  SheetNoise noise;
  std::filesystem::path rest;
  FrameNames frames;
  std::vector<ClipEntry> clips;
  std::optional<TableEntry> table;
};

/// `sample` of session.yaml.
/// @throws InputError
SessionSample read_session_sample(const Value& value, SessionKind kind);

/// `table` of session.yaml.
/// @throws InputError
TableEntry read_table(const Value& value);

/// @throws InputError
SessionDocument read_session_document(const std::filesystem::path& path);
SessionDocument session_document_of(const Document& document);

/// The text of session.yaml that reads back to the same numbers, with the names of files that
/// `session_files` uses.
std::string session_document_text(const Session& session);

}  // namespace pliant
