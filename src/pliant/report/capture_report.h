#pragma once

#include <string>
#include <vector>

#include "pliant/capture/dic_session.h"
#include "pliant/capture/frame_doubts.h"
#include "pliant/capture/shown_view.h"

namespace pliant {

/// Name of the report's file beside the study.
inline constexpr const char* kCaptureReport = "quality.html";

/// What is told of a session that was made from pictures or points.
struct CaptureRecord {
  std::string name;
  const DicSession& made;
  std::vector<FrameDoubt> doubts;
  std::vector<std::string> notes, warnings;
  std::vector<ShownView> views;  ///< empty where there are no pictures
};

/// The report on how well a sample was seen: one self-contained HTML page, like `make_report`.
/// Verdicts are those of the record; it draws.
std::string make_capture_report(const CaptureRecord& record);

}  // namespace pliant
