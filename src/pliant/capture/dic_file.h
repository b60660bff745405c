#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/dic_cells.h"
#include "pliant/capture/dic_reference.h"
#include "pliant/capture/dic_views.h"
#include "pliant/capture/lens.h"
#include "pliant/capture/table_motion.h"
#include "pliant/io/document.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// A side of a rectangular sample: of its least u, largest u, least v, largest v.
enum class SampleSide { left, right, bottom, top };

/// How a clip is known to move.
enum class ClipMotion {
  points,     ///< with the cloth at its edge, as the points beside it move
  held,       ///< not at all
  extension,  ///< away from the sample by the extension in the log of forces
  labels,     ///< as the labels on it show
};

/// A clip, or a jaw, that holds a side of the sample or a part of it.
struct DicClip {
  std::string name;
  SampleSide side = SampleSide::bottom;
  double depth = 0;  ///< of the cloth in it, from the side inwards (m); 0: the side alone
  std::optional<std::pair<double, double>> along;  ///< where on the side (m); none: all of it
  ClipMotion motion = ClipMotion::points;
  double mass = 0;          ///< kg
  std::vector<int> labels;  ///< codes of those on it
};

/// A direction of the points' coordinates: axis 0, 1 or 2, along it (1) or against it (-1).
struct PointAxis {
  int axis = 0;
  double sign = 1;
};

/// When the first frame was taken by the clock of a log.
struct LogStart {
  std::optional<double> time;  ///< s; none: as the motion of the clip, or of cords, tells
  Location where;
};

/// The log of a tester; or of load cells, whose cords are seen; or what cords do, in space.
struct DicForces {
  std::optional<std::filesystem::path> cords;  ///< like cords.csv of a session; then nothing else
  DataSource data;
  std::vector<DicCell> cells;  ///< in place of the clip
  std::string clip;            ///< that the tester pulls
  Location where_clip;
  std::optional<double> rate;     ///< of the frames (1/s); none: a row a frame
  std::optional<LogStart> start;  ///< none: the log's zero, and it covers all frames
  std::optional<double> still;    ///< how long a frame stands still (s); none: between two rows

  /// Whether a tester pulls one clip.
  bool is_tester() const { return !cords && cells.empty(); }

  bool needs_clock() const { return start && !start->time; }
};

/// Pictures of a flat sample by one camera, in which points are tracked.
struct DicPictures {
  std::vector<std::filesystem::path> files;  ///< one a frame, the first at rest
  int patch = 21;                            ///< pixels of a patch's side, odd
  int step = 10;                             ///< pixels from patch to patch
};

/// The labels on clips, as they were printed, in the plane of the sample.
struct DicLabels {
  double tag = 0;                         ///< side of the black square (m)
  double edge = 0;                        ///< from its middle to the line at the clip's edge (m)
  std::optional<Eigen::Vector2d> corner;  ///< of the sample's least u and v, in the first picture
                                          ///< (pixels); none: as the labels say
};

/// What a dic/1 file says of the export of a system for digital image correlation
/// (docs/formats/dic.md). SI units.
struct DicFile {
  std::string file;
  std::string test;
  std::map<std::string, std::string> info;
  SessionSample sample;
  DataSource points;  ///< a file a frame; none where there are pictures or views
  std::optional<DicPictures> pictures;
  std::optional<DicViews> views;
  std::optional<DicReference> camera;       ///< calibration/1
  Lens lens;                                ///< of the camera; a pinhole where none is told
  std::optional<DicReference> labels_file;  ///< pattern/1
  std::optional<DicLabels> labels;          ///< of clips in pictures; they tell scale and origin
  std::vector<int> fixed;                   ///< codes of tags in pictures that stand still
  std::optional<double> scale;              ///< m of one unit of columns that tell none: of a pixel
  std::optional<Eigen::Vector2d>
      origin;  ///< of the sample's corner of least u and v in the points'
               ///< first two coordinates (m); none: it is centred on them
  PointAxis weft{0, 1}, warp{1, 1};
  std::optional<double> mesh;  ///< edge of the sheet's triangles (m); none: as the points lie
  std::optional<Eigen::Vector3d> gravity;  ///< m/s^2; none: what the cameras tell, or none acts
  std::vector<DicClip> clips;              ///< none with a table
  std::optional<DicTable> table;           ///< holds the sample in place of clips
  std::optional<DicForces> forces;

  /// The files of the frames; of several cameras those of the first.
  const std::vector<std::filesystem::path>& files() const;
  int frame_count() const { return static_cast<int>(files().size()); }
  std::string file_of(int frame) const { return files()[static_cast<std::size_t>(frame)].string(); }
  /// Of all clips.
  std::vector<int> label_codes() const {
    std::vector<int> codes;
    for (const DicClip& clip : clips) {
      codes.insert(codes.end(), clip.labels.begin(), clip.labels.end());
    }
    return codes;
  }
  /// Whether a clip moves by the extension of the log.
  bool moves_by_log() const;
  /// The clip of a name, or the end.
  std::vector<DicClip>::const_iterator clip_named(const std::string& name) const;
  /// The clip that the log is of, or the end.
  std::vector<DicClip>::const_iterator pulled_clip() const { return clip_named(forces->clip); }
  /// That of a clip of the file.
  std::size_t clip_number(const std::string& name) const {
    return static_cast<std::size_t>(clip_named(name) - clips.begin());
  }
};

/// Reads what it names, too: the labels and the camera.
/// @throws InputError
DicFile read_dic(const std::filesystem::path& path);
/// The document alone.
DicFile dic_of(const Document& document);

}  // namespace pliant
