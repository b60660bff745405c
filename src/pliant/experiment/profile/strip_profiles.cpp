#include "pliant/experiment/profile/strip_profiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "pliant/base/parallel.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/profile/profile_curvature.h"
#include "pliant/experiment/profile/strip_rests.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

// Elements of a strip that winds: each turns by a few radians at most.
int element_count(double length, double curvature) {
  constexpr double kTurn = 6;
  constexpr int kFewest = 8, kMost = 16;
  return std::clamp(static_cast<int>(std::ceil(length * std::abs(curvature) / kTurn)), kFewest,
                    kMost);
}

constexpr int kFineElements = 24;

constexpr double kDensityChange = 0.05;  // that matters

// Moment per width of what hangs beyond each point of a measured profile ([P] Eq. 7), about it.
std::vector<double> hanging_moments(const ProfileRows& profile, double length, double weight) {
  const std::vector<double> shares = profile.shares();
  std::vector<double> moments(profile.points.size(), 0);
  for (size_t i = 0; i < moments.size(); ++i) {
    for (size_t k = i + 1; k < moments.size(); ++k) {
      const double middle = (profile.points[k].x() + profile.points[k - 1].x()) / 2;
      const double piece = length * (shares[k] - shares[k - 1]);
      moments[i] -= weight * piece * (middle - profile.points[i].x());
    }
  }
  return moments;
}

// Five samples of the spiral, those left out where the weight bends further what stiffness opens:
// they "do not guarantee a monotonic deformation" ([P] 4.3).
void sample_as_published(const ProfileRows& profile, MeasuredPath& path) {
  constexpr int kSamples = 5;
  const std::vector<double> shares = profile.shares();
  const auto first = path.published_samples.begin() + profile.first;
  std::fill_n(first, shares.size(), 0);
  for (int k = 0; k < kSamples; ++k) {
    const double middle = (k + 0.5) / kSamples;  // of one of as many parts
    const auto nearest =
        std::min_element(shares.begin(), shares.end(), [&](double one, double other) {
          return std::abs(one - middle) < std::abs(other - middle);
        });
    const auto point = nearest - shares.begin();
    const auto row = static_cast<size_t>(profile.first + point);
    first[point] = path.force[row] * path.strain[row] <= 0;
  }
}

// The points must be those of the whole strip.
void require_whole(const ProfileRows& profile, double length, const DataRows& data) {
  constexpr double kTolerance = 0.15;  // few points, read with noise
  const double measured = arc_length(profile);
  if (std::abs(measured - length) < kTolerance * length) return;
  throw InputError(data.location(profile.first, "x"),
                   fmt::format("begins a profile that is {} long, but the strip is {}",
                               millimetres(measured), millimetres(length)),
                   "points from the clamp to the free end, close enough to follow the strip");
}

ProfileLine measured_line(const ProfileRows& rows, double length, double weight) {
  ProfileLine line;
  line.setting = rows.setting;
  line.first_row = rows.first;
  for (const double share : rows.shares()) line.arc_length.push_back(share * length);
  for (const Eigen::Vector2d& point : rows.points) {
    line.x.push_back(point.x());
    line.y.push_back(point.y());
  }
  line.curvature = profile_curvature(rows, length);
  line.moment = hanging_moments(rows, length, weight);
  return line;
}

ProfileLine predicted_line(const StripProfile& profile, double setting, double length,
                           double weight) {
  constexpr int kPoints = 150;
  ProfileRows rows{setting, 0, 0, {}};
  ProfileLine line;
  line.setting = setting;
  for (int i = 0; i <= kPoints; ++i) {
    line.arc_length.push_back(length * i / kPoints);
    const StripPoint point = profile.at(line.arc_length.back());
    line.x.push_back(point.position.x());
    line.y.push_back(point.position.y());
    line.curvature.push_back(point.curvature);
    rows.points.push_back(point.position);
  }
  line.moment = hanging_moments(rows, length, weight);
  return line;
}

}  // namespace

StripProfiles::StripProfiles(const ExperimentSpec& spec, const DataRows& data, double density,
                             std::string_view setting)
    : setting_(setting), weight_(density * kStandardGravity) {
  require_density(spec, density);
  measured_ = Eigen::VectorXd::Zero(data.rows());
  profiles_ = read_profiles(data, setting);
  info_ = describe_experiment(spec, data, {"distance_mm", "distance", "mm", 1e3});
  path_.strain.resize(static_cast<size_t>(data.rows()));
  path_.force = path_.strain;
  path_.factor.assign(path_.strain.size(), 1);
  path_.direction.assign(path_.strain.size(), 1);
  path_.anchor.assign(path_.strain.size(), 0);
  path_.specimen.assign(path_.strain.size(), 0);
  path_.starts_flat.assign(path_.strain.size(), 0);
  path_.published_samples.assign(path_.strain.size(), 1);
}

void StripProfiles::estimate_density(double density) {
  nuisance_.push_back({info_.name + ".density", "kg/m^2", density, density / 2, 2 * density,
                       kDensityChange * density});
}

void StripProfiles::add_strip(const ProfileRows& rows, double length, double rolled,
                              const DataRows& data) {
  require_whole(rows, length, data);
  const auto same = std::find_if(strips_.begin(), strips_.end(), [&](const Strip& strip) {
    return strip.rolled == rolled && strip.elastica.line().length() == length;
  });
  if (same == strips_.end()) {
    strips_.push_back({{rows},
                       Elastica(length, element_count(length, rolled)),
                       Elastica(length, kFineElements),
                       rolled});
  } else {
    same->profiles.push_back(rows);
  }
  const std::vector<double> curvature = profile_curvature(rows, length);
  const std::vector<double> moments = hanging_moments(rows, length, weight_);
  const auto first = static_cast<size_t>(rows.first);
  info_.used[first] = 0;  // the clamp
  path_.starts_flat[first] = 1;
  for (size_t i = 0; i < rows.points.size(); ++i) {
    path_.strain[first + i] = kStrainPerCurvature * curvature[i];
    path_.force[first + i] = moments[i];
    path_.anchor[first + i] = rows.first;
    path_.specimen[first + i] = rows.specimen;
    path_.direction[first + i] = rolled < 0 ? 1 : -1;
  }
  if (rolled != 0) sample_as_published(rows, path_);
  path_.strain[first] = kStrainPerCurvature * rolled;
}

double StripProfiles::weight_by(const Eigen::VectorXd& nuisance) const {
  return nuisance.size() > 0 ? nuisance(0) * kStandardGravity : weight_;
}

Eigen::VectorXd StripProfiles::unfitted_nuisance(const ComponentLaw&) const {
  if (nuisance_.empty()) return {};
  return Eigen::VectorXd::Constant(1, nuisance_.front().start);
}

std::optional<HangingStrip> StripProfiles::hang(const Strip& strip, const ComponentLaw& law,
                                                double weight, bool with_derivatives) {
  return hanging_strip({&strip.elastica, &strip.finer}, law, strip.rolled, weight,
                       with_derivatives);
}

void StripProfiles::compare(const ProfileRows& measured, const StripProfile& predicted,
                            double length, Prediction& prediction) {
  const std::vector<double> shares = measured.shares();
  for (size_t i = 0; i < measured.points.size(); ++i) {
    const double place = predicted.nearest(measured.points[i], shares[i] * length);
    const StripPoint nearest = predicted.at(place);
    const Eigen::Vector2d across = nearest.normal();
    const Eigen::Index row = measured.first + static_cast<Eigen::Index>(i);
    prediction.value(row) = across.dot(nearest.position - measured.points[i]);
    prediction.strain(row) = kStrainPerCurvature * nearest.curvature;
    const Eigen::Index parameters = prediction.jacobian.cols();  // or none
    if (parameters == 0) continue;
    prediction.jacobian.row(row) =
        (across.transpose() * predicted.position_by_parameter(place)).leftCols(parameters);
  }
}

std::optional<Prediction> StripProfiles::predict(const ComponentLaw& law,
                                                 const Eigen::VectorXd& nuisance,
                                                 bool with_jacobian) const {
  const auto parameters = with_jacobian ? law.parameter_count() + nuisance.size() : 0;
  const double weight = weight_by(nuisance);
  Prediction prediction;
  prediction.value.setZero(rows());
  prediction.strain.setZero(rows());
  prediction.jacobian.setZero(rows(), parameters);
  std::atomic<bool> found = true;
  const std::vector<const Strip*> strips = slowest_first();
  parallel_for(static_cast<int>(strips.size()), threads_, [&](int i) {
    if (!found) return;
    const Strip& strip = *strips[static_cast<size_t>(i)];
    const std::optional<HangingStrip> hanging = hang(strip, law, weight, with_jacobian);
    if (!hanging) {
      found = false;
      return;
    }
    StripRests rests(*hanging, law, strip.rolled, weight);
    for (const ProfileRows& measured : strip.profiles) {
      compare(measured, rests.profile(rests.nearest(measured), with_jacobian),
              strip.elastica.line().length(), prediction);
    }
  });
  if (!found) return std::nullopt;
  prediction.jacobian.rightCols(with_jacobian ? nuisance.size() : 0) *= kStandardGravity;
  return prediction;
}

// Strips of wide cylinders tip over while they are released, and take longest: they go first, so
// that nobody waits for the last.
std::vector<const StripProfiles::Strip*> StripProfiles::slowest_first() const {
  std::vector<const Strip*> strips;
  for (const Strip& strip : strips_) strips.push_back(&strip);
  const auto radius = [](const Strip* strip) {
    return strip->rolled == 0 ? 0 : 1 / std::abs(strip->rolled);
  };
  std::ranges::stable_sort(strips, std::ranges::greater(), radius);
  return strips;
}

std::unique_ptr<ComponentExperiment> StripProfiles::easy_part() const {
  constexpr std::size_t kFewest = 4;  // of which two are still told apart by their curvature
  std::set<double> curvatures;
  for (const Strip& strip : strips_) {
    if (strip.rolled != 0) curvatures.insert(std::abs(strip.rolled));
  }
  if (curvatures.size() < kFewest) return nullptr;
  const double middle =
      *std::next(curvatures.begin(), static_cast<std::ptrdiff_t>(curvatures.size() / 2));
  auto part = std::make_unique<StripProfiles>(*this);
  std::erase_if(part->strips_, [&](const Strip& strip) { return std::abs(strip.rolled) < middle; });
  for (const Strip& strip : strips_) {
    if (std::abs(strip.rolled) >= middle) continue;
    for (const ProfileRows& profile : strip.profiles) {
      std::fill_n(part->info_.used.begin() + profile.first, profile.points.size(), 0);
    }
  }
  return part;
}

double StripProfiles::reference() const {
  double longest = 0;
  for (const Strip& strip : strips_) longest = std::max(longest, strip.elastica.line().length());
  return longest;
}

std::optional<StripShapes> StripProfiles::shapes(const ComponentLaw& law,
                                                 const Eigen::VectorXd& nuisance) const {
  const double weight = weight_by(nuisance);
  StripShapes shapes;
  shapes.setting_name = setting_;
  for (const Strip& strip : strips_) {
    const std::optional<HangingStrip> hanging = hang(strip, law, weight, false);
    if (!hanging) return std::nullopt;
    const double length = strip.elastica.line().length();
    const double setting = strip.profiles.front().setting;
    StripRests rests(*hanging, law, strip.rolled, weight);
    std::set<std::size_t> taken;
    for (const ProfileRows& rows : strip.profiles) {
      shapes.measured.push_back(measured_line(rows, length, weight));
      const std::size_t rest = rests.nearest(rows);
      taken.insert(rest);
      if (rest > 0) shapes.elsewhere.push_back(setting);
    }
    for (const std::size_t rest : taken) {
      shapes.predicted.push_back(
          predicted_line(rests.profile(rest, false), setting, length, weight));
    }
    if (!rests.others().empty()) shapes.ambiguous.push_back(setting);
    if (strip.rolled != 0) shapes.bent.push_back(bent_and_released(law, setting, strip.rolled));
  }
  return shapes;
}

}  // namespace pliant
