#include "pliant/capture/virtual_capture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/bias_strip.h"
#include "pliant/capture/cloth_print.h"
#include "pliant/capture/grey_png.h"
#include "pliant/capture/pattern.h"
#include "pliant/capture/printed_board.h"
#include "pliant/capture/view_drawing.h"
#include "pliant/capture/virtual_cords.h"
#include "pliant/capture/virtual_rig.h"
#include "pliant/experiment/session/session_type.h"

namespace pliant {
namespace {

constexpr double kLabel = 12e-3, kLabelMargin = 2e-3;  // side of a label's tag, white around it (m)
constexpr double kPlate = 0.8e-3;                      // of a clip above and below the cloth (m)

/// The board fills half of the picture where the sheet is.
TagBoard board_for(const VirtualCameras& options) {
  TagBoard board;
  board.columns = 5;
  board.rows = 4;
  constexpr double kShare = 0.08;  // of the picture's width: a tag, to a tenth of a millimetre
  board.tag = 1e-4 * std::round(kShare * options.columns * options.pixel / 1e-4);
  board.gap = 1e-4 * std::round(board.tag / 4 / 1e-4);
  return board;
}

/// Where a clip is beside the sheet, and what it covers.
struct DrawnClip {
  Eigen::Index axis = 0;  // across its side
  const char* side = "left";
  Eigen::AlignedBox2d cloth;            // at rest (m)
  std::vector<Eigen::Vector2d> labels;  // their middles
  std::vector<int> codes;               // likewise
};

/// Middles of some labels on a clip.
using LabelChoice = std::vector<Eigen::Vector2d>;

/// Two far apart tell best how a bar has turned; where cords swing over its ends they are nearer to
/// its middle. Where cords cross those, too, there are three, of which some are whole, or on a
/// short bar one. Beside a corner they are on an arm along the sheet.
std::vector<LabelChoice> label_choices(const DrawnClip& clip, const Eigen::Vector2d& size) {
  constexpr double kBeside = 1e-3, kOfCord = 3e-3;  // m
  const bool is_first = clip.cloth.min()(clip.axis) < size(clip.axis) - clip.cloth.max()(clip.axis);
  const Eigen::Index along = 1 - clip.axis;
  const auto labels = [&](const std::vector<double>& off_middle) {
    const double out = kLabel / 2 + kLabelMargin + kBeside;
    LabelChoice choice;
    for (const double off : off_middle) {
      Eigen::Vector2d middle = clip.cloth.center();
      middle(clip.axis) = is_first ? -out : size(clip.axis) + out;
      middle(along) += off;
      choice.push_back(middle);
    }
    return choice;
  };
  const double half = clip.cloth.sizes()(along) / 2, room = kLabel / 2 + kLabelMargin;
  const double apart = half - room - kOfCord;
  const double inwards = clip.cloth.center()(along) < size(along) / 2 ? 1 : -1;
  std::vector<LabelChoice> choices;
  for (const double share : {1.0, 0.8, 0.6, 0.4}) {
    const double off = share * apart;
    if (off >= room) choices.push_back(labels({-off, off}));
  }
  if (apart >= 2 * room) {
    choices.push_back(labels({-apart, 0, apart}));
    return choices;
  }
  if (half < 2 * room) {
    const double beside = inwards * (half + room + kOfCord), next = beside + inwards * 2 * room;
    if (std::abs(next) + room < size(along) / 2 - half) choices.push_back(labels({beside, next}));
    choices.push_back(labels({beside}));
  }
  choices.push_back(labels({0}));
  return choices;
}

/// Whether a cord of the clip passes over a label in some frame, or so near that a camera may see
/// it there.
bool is_crossed(const Session& session, std::size_t clip, const LabelChoice& choice) {
  constexpr double kNear = 2e-3, kStep = 1e-3;  // m
  constexpr int kSteps = 60;
  for (const SessionFrame& frame : session.frames) {
    for (const CordForce& cord : frame.cords[clip]) {
      const Pose& pose = frame.poses[clip];
      const Eigen::Vector3d from = pose.local(cord.point);
      const Eigen::Vector3d along = pose.rotation.conjugate() * cord.force.normalized();
      for (int i = 0; i < kSteps; ++i) {
        const Eigen::Vector2d at = (from + i * kStep * along).head<2>();
        const bool is_near = std::ranges::any_of(choice, [&](const Eigen::Vector2d& middle) {
          return (at - middle).cwiseAbs().maxCoeff() < kLabel / 2 + kLabelMargin + kNear;
        });
        if (is_near) return true;
      }
    }
  }
  return false;
}

/// @param first_code  of its labels
DrawnClip drawn_clip(const Session& session, std::size_t number, int first_code) {
  constexpr std::array kSides{"left", "right", "bottom", "top"};
  DrawnClip drawn;
  for (const int vertex : session.clips[number].clamped) {
    drawn.cloth.extend(session.rest.positions.col(vertex).head<2>());
  }
  const Eigen::Vector2d size(session.sample.width, session.sample.height);
  const Eigen::Vector2d low = drawn.cloth.min(), high = size - drawn.cloth.max();
  // Along the shorter extent it is deep, along the longer one it is wide.
  drawn.axis = drawn.cloth.sizes().x() <= drawn.cloth.sizes().y() ? 0 : 1;
  const bool is_first = low(drawn.axis) < high(drawn.axis);
  drawn.side = kSides[static_cast<std::size_t>(2 * drawn.axis + (is_first ? 0 : 1))];
  const std::vector<LabelChoice> choices = label_choices(drawn, size);
  const auto clear = std::ranges::find_if(
      choices, [&](const LabelChoice& choice) { return !is_crossed(session, number, choice); });
  drawn.labels = clear == choices.end() ? choices.back() : *clear;
  drawn.codes.resize(drawn.labels.size());
  std::iota(drawn.codes.begin(), drawn.codes.end(), first_code);
  return drawn;
}

/// A half of a clip, over the cloth or under it.
DrawnSurface plate(const Eigen::AlignedBox2d& box, double height) {
  constexpr double kMetal = 0.45;
  return flat_rectangle(box, height, [](const Eigen::Vector2d&) { return kMetal; });
}

ClothPrint print_on(const SessionSample& sample, double pixel, std::uint64_t seed) {
  ClothPattern pattern;
  pattern.seed = seed;
  pattern.camera = pixel;
  pattern.finest = 4 * pixel;
  const double fine = pixel / 4;
  const auto pixels = [&](double size) { return static_cast<int>(std::ceil(size / fine)) + 1; };
  return {pattern, pixels(sample.width), pixels(sample.height), fine};
}

/// Everything before the cameras, picture by picture.
class DrawnSession {
 public:
  DrawnSession(const Session& session, const VirtualCameras& options, std::uint64_t seed)
      : session_(session),
        gloss_(options.gloss),
        print_(print_on(session.sample, options.pixel, seed)) {
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      const int first_code = clips_.empty() ? 0 : clips_.back().codes.back() + 1;
      clips_.push_back(drawn_clip(session, c, first_code));
    }
  }

  const std::vector<DrawnClip>& clips() const { return clips_; }

  /// @param frame  -1: at rest
  std::vector<DrawnSurface> surfaces(int frame) const {
    std::vector<DrawnSurface> surfaces;
    if (session_.table) surfaces.push_back(table_top());
    for (std::size_t c = 0; c < clips_.size(); ++c) {
      std::vector<DrawnSurface> own{plate(clips_[c].cloth, kPlate),
                                    plate(clips_[c].cloth, -kPlate)};
      for (std::size_t i = 0; i < clips_[c].labels.size(); ++i) {
        own.push_back(
            label_surface(clips_[c].codes[i], kLabel, kLabelMargin, clips_[c].labels[i], kPlate));
      }
      for (DrawnSurface& surface : own) {
        if (frame >= 0) move(surface, session_.frames[static_cast<std::size_t>(frame)].poses[c]);
        surfaces.push_back(std::move(surface));
      }
    }
    if (frame >= 0) {
      for (DrawnSurface& cord : cord_surfaces(session_.frames[static_cast<std::size_t>(frame)])) {
        surfaces.push_back(std::move(cord));
      }
    }
    DrawnSurface sheet;
    sheet.positions = frame < 0 ? session_.rest.positions
                                : session_.frames[static_cast<std::size_t>(frame)].positions;
    sheet.triangles = session_.rest.triangles;
    sheet.places = session_.rest.positions.topRows<2>();
    sheet.gloss = gloss_;
    sheet.brightness = [this](const Eigen::Vector2d& place) { return print_.at(place); };
    if (session_.table) push(sheet, frame);
    surfaces.push_back(std::move(sheet));
    return surfaces;
  }

 private:
  /// The table stays where it is, its edge where the sheet ends at rest.
  double edge() const {
    return *session_.table == RestAxis::u ? session_.sample.width : session_.sample.height;
  }

  DrawnSurface table_top() const {
    constexpr double kBelow = 0.3e-3, kBeside = 0.05, kWood = 0.3;  // m, m
    const auto axis = static_cast<Eigen::Index>(*session_.table);
    Eigen::AlignedBox2d box(Eigen::Vector2d::Constant(-kBeside),
                            Eigen::Vector2d(session_.sample.width, session_.sample.height) +
                                Eigen::Vector2d::Constant(kBeside));
    box.max()(axis) = edge();
    return flat_rectangle(box, -kBelow, [](const Eigen::Vector2d&) { return kWood; });
  }

  /// Frames are in the sheet's own axes.
  void push(DrawnSurface& sheet, int frame) const {
    if (frame < 0) return;
    const double by = edge() - *session_.frames[static_cast<std::size_t>(frame)].table_edge;
    sheet.positions.row(static_cast<Eigen::Index>(*session_.table)).array() += by;
  }

  static void move(DrawnSurface& surface, const Pose& pose) {
    for (auto place : surface.positions.colwise()) place = pose.apply(place);
  }

  const Session& session_;
  double gloss_;
  ClothPrint print_;
  std::vector<DrawnClip> clips_;
};

/// The board, somewhere before the cameras; in the first shot on the table.
DrawnSurface placed_board(const TagBoard& board, const VirtualCameras& options,
                          const Eigen::Vector2d& middle, int shot, const RandomStream& random) {
  constexpr double kTilt = 0.6, kTurn = 0.5;       // rad
  constexpr double kAside = 0.18, kNearer = 0.12;  // of the picture's width, of the distance
  DrawnSurface surface = board_surface(board);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translate(Eigen::Vector3d(middle.x(), middle.y(), 0));
  if (shot > 0) {
    RandomStream own = random.split(fmt::format("board {}", shot));
    const auto any = [&](double most) { return own.uniform(-most, most); };
    const double aside = kAside * options.columns * options.pixel;
    place.translate(Eigen::Vector3d(any(aside), any(aside), any(kNearer * options.distance)));
    place.rotate(Eigen::AngleAxisd(any(kTilt), Eigen::Vector3d::UnitX()) *
                 Eigen::AngleAxisd(any(kTilt), Eigen::Vector3d::UnitY()) *
                 Eigen::AngleAxisd(any(kTurn), Eigen::Vector3d::UnitZ()));
  }
  const Eigen::Vector2d half = board.extent() / 2;
  place.translate(Eigen::Vector3d(-half.x(), -half.y(), 0));
  for (auto corner : surface.positions.colwise()) corner = place * Eigen::Vector3d(corner);
  return surface;
}

std::string pictures_yaml(const VirtualCameras& options, const char* folder) {
  std::string text;
  for (int c = 0; c < options.count; ++c) {
    text += fmt::format("{}{}: \"{}/{}/*.png\"", c == 0 ? "" : ", ", virtual_camera_name(c), folder,
                        virtual_camera_name(c));
  }
  return text;
}

std::string rig_text(const VirtualCameras& options) {
  std::string text = "pliant: rig/1\ncameras:\n";
  for (int c = 0; c < options.count; ++c)
    text += fmt::format("  {}: {{}}\n", virtual_camera_name(c));
  return text + fmt::format(
                    "calibration:\n  boards: [board.yaml]\n  pictures:\n    - {{{}}}\n"
                    "  gravity: {{level: boards/camera1/000.png}}\n",
                    pictures_yaml(options, "boards"));
}

/// @param forces  of the file; of a sheet on a table none
std::string capture_text(const Session& session, const VirtualCameras& options,
                         const std::vector<DrawnClip>& clips, const CameraModel& first,
                         const std::string& forces) {
  const double width = session.sample.width, height = session.sample.height;
  constexpr int kDigits = 6;
  const auto length = [](double metres) {
    return format_quantity(metres, Dimension::length, kDigits);
  };
  std::string corners;
  for (const auto& [u, v] : std::array{std::pair(0.0, 0.0), std::pair(width, 0.0),
                                       std::pair(width, height), std::pair(0.0, height)}) {
    const auto pixel = first.project({u, v, 0});
    corners +=
        fmt::format("{}[{:.2f}, {:.2f}]", corners.empty() ? "" : ", ", pixel->x(), pixel->y());
  }
  std::string text = fmt::format(
      "# pliant calibrate rig.yaml -o calibration\n# pliant import --dic capture.yaml -o seen\n"
      "pliant: dic/1\ntest: {}\nsample: {{width: {}, height: {}, mass: {}}}\n"
      "views:\n  calibration: calibration/calibration.json\n  pictures: {{{}}}\n"
      "  corners: [{}]\n",
      session.test, length(width), length(height),
      exact_quantity(*session.sample.mass, Dimension::mass), pictures_yaml(options, "pictures"),
      corners);
  if (session.table) {
    const bool across_weft = *session.table == RestAxis::u;
    return text + fmt::format("table: {{{}: {}}}\n", across_weft ? "edge_x" : "edge_y",
                              length(across_weft ? width : height));
  }
  text += "clips:\n";
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const DrawnClip& clip = clips[c];
    const Eigen::Index deep = clip.axis;
    text += fmt::format(
        "  - {{name: {}, side: {}, depth: {}, along: [{}, {}], labels: [{}], mass: {}}}\n",
        session.clips[c].name, clip.side, length(clip.cloth.sizes()(deep)),
        length(clip.cloth.min()(1 - deep)), length(clip.cloth.max()(1 - deep)),
        fmt::join(clip.codes, ", "), exact_quantity(session.clips[c].mass, Dimension::mass));
  }
  return text + forces;
}

/// What the cameras look at: the middle of the sheet, or of the edge over which it is pushed.
Eigen::Vector2d middle_of(const Session& session) {
  Eigen::Vector2d middle(session.sample.width / 2, session.sample.height / 2);
  if (session.table) middle(static_cast<Eigen::Index>(*session.table)) *= 2;
  return middle;
}

}  // namespace

void require_seen(const VirtualTest& test) {
  const auto* session = dynamic_cast<const VirtualSessionTest*>(&test);
  if (!session) return;
  const std::string& name = session->session.test;
  const bool has_clips = session_test_kind(name).clip_mass > 0 && name != kBiasExtension;
  if (has_clips || name.starts_with("bend-")) return;
  throw InputError(test.where, quoted_value(name) + " is not a test that cameras are drawn of yet",
                   "sheets between clips, cut along weft and warp, or over the edge of a table; or "
                   "a lab without `cameras`");
}

void draw_capture(const Session& session, const VirtualCameras& options, const RunContext& context,
                  const WriteFile& write) {
  const Eigen::Vector2d middle = middle_of(session);
  const std::vector<CameraModel> cameras = virtual_rig(options, middle);
  const RandomStream random = RandomStream(context.seed).split("pictures");
  const ChipNoise noise{options.read_noise, options.shot_noise, options.bits};
  ViewOptions light;
  light.light = {0.4, -0.3, 1};
  light.blur = options.blur;
  const auto draw = [&](const std::string& folder, int number,
                        const std::vector<DrawnSurface>& surfaces) {
    context.stop.throw_if_requested();
    for (int c = 0; c < options.count; ++c) {
      const std::string name =
          fmt::format("{}/{}/{:03}.png", folder, virtual_camera_name(c), number);
      GreyPicture picture;
      with_threads(context.threads, [&] {
        picture = draw_view(cameras[static_cast<std::size_t>(c)], surfaces, light);
      });
      RandomStream own = random.split(name);
      add_chip_noise(picture, noise, own);
      write(name, options.bits > 8 ? deep_grey_png_bytes(picture, 1 / options.pixel)
                                   : grey_png_bytes(picture, 1 / options.pixel));
    }
  };

  const TagBoard board = board_for(options);
  const int frames = session.frame_count();
  ProgressTask task(context.progress, "pictures", options.boards + frames + 1);
  for (int shot = 0; shot < options.boards; ++shot) {
    draw("boards", shot, {placed_board(board, options, middle, shot, random)});
    task.advance(shot + 1);
  }
  const DrawnSession drawn(session, options, context.seed);
  for (int frame = -1; frame < frames; ++frame) {
    draw("pictures", frame + 1, drawn.surfaces(frame));
    task.advance(options.boards + frame + 2);
  }
  Pattern print;
  print.kind = board;
  write("board.yaml", pattern_text(print));
  write("rig.yaml", rig_text(options));
  write("truth.json", true_calibration_text(cameras));
  const VirtualCells cells(session, options, random);
  const auto picture = [](std::size_t camera, int frame) {
    return fmt::format("pictures/{}/{:03}.png", virtual_camera_name(static_cast<int>(camera)),
                       frame + 1);
  };
  if (!cells.empty()) write("cells.csv", cells.log());
  write("capture.yaml",
        capture_text(session, options, drawn.clips(), cameras.front(),
                     cells.empty() ? "" : cells.forces_yaml("cells.csv", cameras, picture)));
}

}  // namespace pliant
