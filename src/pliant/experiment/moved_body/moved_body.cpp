#include "pliant/experiment/moved_body/moved_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/moved_body/moved_body_predictor.h"

namespace pliant {
namespace {

constexpr std::array kAxes{"x", "y", "z"};
constexpr double kOffSurface = 0.5;  // of an edge: farther away is not on the body
constexpr double kSomeStress = 1e4;  // Pa; where no force tells it

/// The area of the surface that some nodes have to themselves; of edges and single nodes that of a
/// tenth of the body.
double area_of(const VolumeMesh& mesh, const std::vector<int>& nodes) {
  double area = 0;
  const Eigen::Matrix3Xi triangles = boundary_surface(mesh).triangles;
  for (const auto& t : triangles.colwise()) {
    const bool all =
        std::ranges::all_of(t, [&](int node) { return std::ranges::binary_search(nodes, node); });
    if (!all) continue;
    const Eigen::Vector3d a = mesh.positions.col(t(0));
    const Eigen::Vector3d to_b = mesh.positions.col(t(1)) - a, to_c = mesh.positions.col(t(2)) - a;
    area += to_b.cross(to_c).norm() / 2;
  }
  const double tenth = extent_of(mesh) / 10;
  return area > 0 ? area : tenth * tenth;
}

std::vector<Eigen::Vector3d> places_of(const DataRows& points) {
  std::vector<Eigen::Vector3d> places(static_cast<std::size_t>(points.rows()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double> along = points.quantity(kAxes[axis], Dimension::length);
    for (std::size_t row = 0; row < along.size(); ++row) {
      places[row](static_cast<Eigen::Index>(axis)) = along[row];
    }
  }
  return places;
}

double stated(const std::optional<double>& noise, const char* key, const ExperimentSpec& spec) {
  if (noise) return *noise;
  throw InputError(
      spec.where,
      fmt::format("states no noise of the {}, by which forces and positions are weighed", key),
      "`noise: {force: 10 mN, length: 0.1 mm}`, standard deviations");
}

}  // namespace

MovedBodyTest::MovedBodyTest(const ExperimentSpec& spec, const DataRows& data,
                             const DataRows* points)
    : spec_(std::dynamic_pointer_cast<const MovedBodySpec>(spec.test)) {
  if (data.specimens().size() > 1) {
    throw InputError(data.location(0, "specimen"), "has several specimens",
                     "one body an experiment");
  }
  read_shifts(data);
  std::vector<Row> rows;
  append_forces(data, spec, rows);
  if (points) append_positions(*points, spec, rows);
  if (rows.empty()) {
    throw InputError(data.location(0, ""), "has neither forces nor positions of marks",
                     "columns force_x, force_y, force_z, or `points:` in the study");
  }
  info_ = describe_experiment(spec, data, {"reading", "reading", "sd", 1});
  take_rows(rows);
  describe_rows();
}

void MovedBodyTest::read_shifts(const DataRows& data) {
  std::array<std::vector<double>, 3> along;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string column = fmt::format("shift_{}", kAxes[i]);
    along[i] = data.optional_quantity(column, Dimension::length)
                   .value_or(std::vector<double>(static_cast<std::size_t>(data.rows()), 0.0));
  }
  for (std::size_t row = 0; row < along[0].size(); ++row) {
    shifts_.emplace_back(along[0][row], along[1][row], along[2][row]);
  }
  const bool moves =
      std::ranges::any_of(shifts_, [](const Eigen::Vector3d& shift) { return !shift.isZero(); });
  if (moves) return;
  throw InputError(data.location(0, "shift_x"), "moves nowhere",
                   "columns shift_x, shift_y, shift_z: how far `moved` is from where it rests");
}

void MovedBodyTest::append_forces(const DataRows& data, const ExperimentSpec& spec,
                                  std::vector<Row>& rows) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto force = data.optional_quantity(
        fmt::format("force_{}", kAxes[static_cast<std::size_t>(axis)]), Dimension::force);
    if (!force) continue;
    const double noise = stated(spec.noise.force, "force", spec);
    for (int frame = 0; frame < data.rows(); ++frame) {
      const double value = (*force)[static_cast<std::size_t>(frame)];
      rows.push_back({{frame, -1, axis, noise}, value});
      largest_force_ = std::max(largest_force_, std::abs(value));
    }
  }
}

std::map<std::string, int> MovedBodyTest::read_marks(const DataRows& points,
                                                     const std::vector<long>& frames,
                                                     const std::vector<std::string>& names,
                                                     const std::vector<Eigen::Vector3d>& places) {
  const VolumeMesh& mesh = setup().mesh;
  const Eigen::Matrix3Xi triangles = boundary_surface(mesh).triangles;
  const double edge = mean_surface_edge(mesh);
  std::map<std::string, int> marks;
  for (std::size_t row = 0; row < names.size(); ++row) {
    if (frames[row] != 0) continue;
    const Location where = points.location(static_cast<int>(row), "point");
    if (!marks.try_emplace(names[row], static_cast<int>(marks_.size())).second) {
      throw InputError(where, quoted_value(names[row]) + " is at rest twice",
                       "one row of frame 0 a point");
    }
    const Eigen::Vector3d& rest = places[row];
    const SurfacePlace place = nearest_on_surface(mesh.positions, triangles, rest);
    if (place.distance > kOffSurface * edge) {
      throw InputError(where,
                       fmt::format("{} lies {} off the surface of the body",
                                   quoted_value(names[row]), millimetres(place.distance)),
                       "places on the mesh's surface, in its coordinates after `unit` and `up`");
    }
    marks_.push_back({names[row], place, rest});
  }
  return marks;
}

void MovedBodyTest::append_positions(const DataRows& points, const ExperimentSpec& spec,
                                     std::vector<Row>& rows) {
  const double noise = stated(spec.noise.length, "length", spec);
  const auto frames = points.optional_integers("frame");
  const auto names = points.optional_texts("point");
  if (!frames || !names) {
    throw InputError(points.location(0, frames ? "point" : "frame"), "is not there",
                     "columns frame (0: at rest, then the rows of `data`), point, x, y, z");
  }
  const std::vector<Eigen::Vector3d> places = places_of(points);
  const std::map<std::string, int> marks = read_marks(points, *frames, *names, places);
  for (std::size_t row = 0; row < names->size(); ++row) {
    const long frame = (*frames)[row];
    if (frame == 0) continue;
    if (frame < 0 || frame > std::ssize(shifts_)) {
      throw InputError(points.location(static_cast<int>(row), "frame"),
                       fmt::format("{} is no row of `data`", frame),
                       fmt::format("0 (at rest) to {}", shifts_.size()));
    }
    const auto mark = marks.find((*names)[row]);
    if (mark == marks.end()) {
      throw InputError(points.location(static_cast<int>(row), "point"),
                       quoted_value((*names)[row]) + " is nowhere at rest",
                       "a row of frame 0 for each point");
    }
    const Eigen::Vector3d& rest = marks_[static_cast<std::size_t>(mark->second)].rest;
    for (int axis = 0; axis < 3; ++axis) {
      rows.push_back({{static_cast<int>(frame) - 1, mark->second, axis, noise},
                      places[row](axis) - rest(axis)});
    }
  }
}

void MovedBodyTest::take_rows(const std::vector<Row>& rows) {
  std::vector<Row> sorted = rows;
  std::ranges::stable_sort(sorted, {}, [](const Row& row) { return row.reading.frame; });
  measured_.resize(std::ssize(sorted));
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const BodyReading& reading = sorted[i].reading;
    readings_.push_back(reading);
    measured_(static_cast<Eigen::Index>(i)) = sorted[i].value / reading.noise;
    if (frames_.empty() ||
        readings_[static_cast<std::size_t>(frames_.back().first)].frame != reading.frame) {
      frames_.push_back({static_cast<int>(i), 0, 0});
    }
    ++frames_.back().count;
  }
}

// Rows of the table are frames; rows of the experiment are their readings.
void MovedBodyTest::describe_rows() {
  std::vector<char> used;
  std::vector<double> time;
  OwnColumn frame{"frame", {}}, what{"of", {}}, noise{"sd_SI", {}};
  for (const BodyReading& reading : readings_) {
    const auto of_frame = static_cast<std::size_t>(reading.frame);
    used.push_back(info_.used[of_frame]);
    if (!info_.time.empty()) time.push_back(info_.time[of_frame]);
    const char* axis = kAxes[static_cast<std::size_t>(reading.axis)];
    frame.cells.push_back(std::to_string(reading.frame + 1));
    what.cells.push_back(
        reading.mark < 0
            ? fmt::format("force_{}", axis)
            : fmt::format("{} {}", marks_[static_cast<std::size_t>(reading.mark)].name, axis));
    noise.cells.push_back(fmt::format("{:.6g}", reading.noise));
  }
  info_.used = std::move(used);
  info_.time = std::move(time);
  info_.columns = {std::move(frame), std::move(what), std::move(noise)};
  info_.force_noise = 1;
  info_.length_noise.reset();
  info_.handled.push_back(fmt::format("{} frames with {} marks: {} readings, each in its noise",
                                      shifts_.size(), marks_.size(), readings_.size()));
}

std::vector<std::vector<int>> MovedBodyTest::series() const {
  std::array<std::vector<int>, 3> forces;
  std::vector<std::vector<int>> marks(3 * shifts_.size());
  for (std::size_t row = 0; row < readings_.size(); ++row) {
    const BodyReading& reading = readings_[row];
    const auto axis = static_cast<std::size_t>(reading.axis);
    std::vector<int>& own =
        reading.mark < 0 ? forces[axis] : marks[3 * static_cast<std::size_t>(reading.frame) + axis];
    own.push_back(static_cast<int>(row));
  }
  std::ranges::copy(forces, std::back_inserter(marks));
  std::erase_if(marks, [](const std::vector<int>& rows) { return rows.empty(); });
  return marks;
}

double MovedBodyTest::stress() const {
  return largest_force_ > 0 ? largest_force_ / area_of(setup().mesh, setup().moved) : kSomeStress;
}

std::vector<double> MovedBodyTest::imposed() const {
  const double extent = extent_of(setup().mesh);
  std::vector<double> shares;
  for (const BodyReading& reading : readings_) {
    shares.push_back(shifts_[static_cast<std::size_t>(reading.frame)].norm() / extent);
  }
  return shares;
}

std::vector<std::string> MovedBodyTest::differences(const Eigen::VectorXd& predicted) const {
  struct Kind {
    double squares = 0, largest = 0;
    int rows = 0;
  };
  std::array<Kind, 2> kinds;  // forces, positions
  for (std::size_t row = 0; row < readings_.size(); ++row) {
    if (!info_.used[row]) continue;
    const auto i = static_cast<Eigen::Index>(row);
    const double noise = readings_[row].noise;
    Kind& kind = kinds[readings_[row].mark < 0 ? 0 : 1];
    kind.squares += std::pow(noise * (predicted(i) - measured_(i)), 2);
    kind.largest = std::max(kind.largest, noise * std::abs(measured_(i)));
    ++kind.rows;
  }
  std::vector<std::string> texts;
  const auto tell = [&](const Kind& kind, const char* what, Dimension dimension) {
    if (kind.rows == 0) return;
    texts.push_back(fmt::format("{} off by {} (RMS), the largest of {}", what,
                                format_quantity(std::sqrt(kind.squares / kind.rows), dimension),
                                format_quantity(kind.largest, dimension)));
  };
  tell(kinds[0], "forces", Dimension::force);
  tell(kinds[1], "ways of marks", Dimension::length);
  return texts;
}

std::unique_ptr<Predictor> MovedBodyTest::predictor(const Material& material) const {
  std::vector<Eigen::Vector3d> shifts;
  for (const Frame& frame : frames_) {
    const int measured = readings_[static_cast<std::size_t>(frame.first)].frame;
    shifts.push_back(shifts_[static_cast<std::size_t>(measured)]);
  }
  return std::make_unique<MovedBodyPredictor>(
      setup(), MovedBodyPredictor::Schedule{frames_, std::move(shifts), *this}, material);
}

BodyReadout MovedBodyTest::read(int row, const Eigen::Matrix3Xd& positions,
                                const Eigen::Vector3d& force) const {
  const BodyReading& reading = readings_[static_cast<std::size_t>(row)];
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(reading.axis) / reading.noise;
  if (reading.mark < 0) return {along.dot(force), along};
  const SurfacePlace& place = marks_[static_cast<std::size_t>(reading.mark)].place;
  BodyReadout readout{along.dot(place.at(positions) - place.at(setup().mesh.positions))};
  for (int i = 0; i < 3; ++i) {
    readout.by_node.emplace_back(place.nodes(i), place.shares(i) * along);
  }
  return readout;
}

}  // namespace pliant
