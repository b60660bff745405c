#include "pliant/experiment/loop_figures.h"

#include <cmath>
#include <map>
#include <optional>

#include "pliant/experiment/loop_branches.h"
#include "pliant/experiment/pulled_figures.h"
#include "pliant/material/kes_bending.h"
#include "pliant/material/kes_shear.h"

namespace pliant {
namespace {

/// Figures of several specimens by their names, in the order in which they were first met.
class SpecimenMeans {
 public:
  void add(const char* name, double value) {
    if (!std::isfinite(value)) return;
    const auto known = places_.try_emplace(name, all_.size());
    if (known.second) all_.push_back({name, 0, 0});
    Sum& sum = all_[known.first->second];
    sum.value += value;
    ++sum.count;
  }

  std::vector<LoopFigure> means() const {
    std::vector<LoopFigure> means;
    for (const Sum& sum : all_) means.push_back({sum.name, sum.value / sum.count});
    return means;
  }

 private:
  struct Sum {
    std::string name;
    double value;
    int count;
  };
  std::vector<Sum> all_;
  std::map<std::string, std::size_t> places_;
};

PulledWay pulled_way(const LoopBranch& branch, const LoopSeries& series) {
  PulledWay way;
  for (std::size_t i = 0; i < branch.x.size(); ++i) {
    way.extension.push_back(branch.x[i] / series.length - 1);
    way.load.push_back(branch.y[i] / series.width);
  }
  return way;
}

/// The pulls of one specimen with what follows each.
std::vector<PulledCycle> cycles_of(const std::vector<LoopBranch>& branches, int specimen,
                                   const LoopSeries& series) {
  std::vector<PulledCycle> cycles;
  for (const LoopBranch& branch : branches) {
    if (branch.specimen != specimen) continue;
    if (branch.direction > 0) {
      cycles.push_back({pulled_way(branch, series), {}});
    } else if (!cycles.empty()) {
      cycles.back().back = pulled_way(branch, series);
    }
  }
  return cycles;
}

void add_kes_tensile(const std::vector<PulledCycle>& cycles, SpecimenMeans& means) {
  for (const PulledCycle& cycle : cycles) {
    const auto kes = kes_tensile(cycle);
    if (!kes) continue;
    means.add("kes_EMT", kes->extension);
    means.add("kes_LT", kes->linearity);
    means.add("kes_WT", kes->work);
    if (kes->resilience) means.add("kes_RT", *kes->resilience);
    return;
  }
}

void add_fast(const std::vector<PulledCycle>& cycles, bool bias, SpecimenMeans& means) {
  constexpr const char* kNames[] = {"fast_E5", "fast_E20", "fast_E100"};
  for (int i = 0; i < 3; ++i) {
    for (const PulledCycle& cycle : cycles) {
      const auto extension = cycle.out.extension_at(kFastLoads[i]);
      if (!extension) continue;
      means.add(kNames[i], *extension);
      if (bias && i == 0 && *extension > 0) means.add("fast_G", fast_shear_rigidity(*extension));
      break;
    }
  }
}

void add_recovery(const std::vector<PulledCycle>& cycles, SpecimenMeans& means) {
  const auto recovery = cycles.empty() ? std::nullopt : elastic_recovery(cycles.back());
  if (!recovery) return;
  means.add("iso_elongation", recovery->elongation);
  means.add("iso_permanent", recovery->permanent);
  means.add("iso_recovery", recovery->recovery());
}

/// The last way of a specimen in a direction that passes both places; null where none does.
const LoopBranch* last_way(const std::vector<LoopBranch>& branches, int specimen, int direction,
                           double from, double to) {
  const LoopBranch* last = nullptr;
  for (const LoopBranch& branch : branches) {
    if (branch.specimen != specimen || branch.direction != direction) continue;
    if (branch.at(from) && branch.at(to)) last = &branch;
  }
  return last;
}

/// What is imposed on a chart's abscissa, of what the standard counts by.
using PlaceOf = double (*)(double);

/// The last ways that pass both places on each side: of one cycle from rest the way out to the
/// positive side begins at rest, as the instrument draws it.
std::optional<LoopWays> last_ways(const std::vector<LoopBranch>& branches, int specimen,
                                  double from, double to, PlaceOf place_of) {
  const auto way = [&](int direction, int side) {
    return last_way(branches, specimen, direction, place_of(side * from), place_of(side * to));
  };
  const auto value = [place_of](const LoopBranch* positive, const LoopBranch* negative) {
    return [=](double at) {
      const LoopBranch* branch = at < 0 ? negative : positive;
      return branch ? branch->at(place_of(at)).value_or(NAN) : NAN;
    };
  };
  const LoopBranch *up = way(1, 1), *down = way(-1, 1);
  const LoopBranch *negative_up = way(1, -1), *negative_down = way(-1, -1);
  if (!up || !down) return std::nullopt;
  const bool both = negative_up && negative_down;
  return LoopWays{value(up, negative_up), value(down, negative_down), both};
}

void add_shear(const std::vector<LoopBranch>& branches, int specimen, SpecimenMeans& means) {
  const PlaceOf strain = [](double angle) { return std::sin(angle); };
  const auto [from, to] = kKesSlopeAngle;
  if (const auto loop = last_ways(branches, specimen, from, to, strain)) {
    means.add("kes_G", mean_slope(*loop, from, to));
    means.add("kes_2HG", mean_width(*loop, kKesHysteresisAngle[0]));
  }
  const double five = kKesHysteresisAngle[1];
  if (const auto loop = last_ways(branches, specimen, five, five, strain)) {
    means.add("kes_2HG5", mean_width(*loop, five));
  }
}

void add_bending(const std::vector<LoopBranch>& branches, int specimen, SpecimenMeans& means) {
  const PlaceOf curvature = [](double at) { return at; };
  const auto [from, to] = kKesSlopeCurvature;
  const auto loop = last_ways(branches, specimen, from, to, curvature);
  if (!loop) return;
  means.add("kes_B", mean_slope(*loop, from, to));
  means.add("kes_2HB", mean_width(*loop, kKesHysteresisCurvature));
}

}  // namespace

std::vector<LoopFigure> loop_figures(const ComponentExperiment& experiment,
                                     const Eigen::VectorXd& quantity) {
  const auto series = experiment.loop(quantity);
  const ExperimentInfo& info = experiment.info();
  if (!series || !info.test.deformation) return {};
  const std::vector<LoopBranch> branches = branches_of(*series, experiment.path());
  SpecimenMeans means;
  for (int specimen = 0; specimen < std::ssize(info.specimens); ++specimen) {
    if (info.test.deformation == Deformation::stretch) {
      const std::vector<PulledCycle> cycles = cycles_of(branches, specimen, *series);
      add_kes_tensile(cycles, means);
      add_fast(cycles, info.direction == "bias", means);
      add_recovery(cycles, means);
    } else if (info.test.deformation == Deformation::shear) {
      add_shear(branches, specimen, means);
    } else if (info.test.deformation == Deformation::bend) {
      add_bending(branches, specimen, means);
    }
  }
  return means.means();
}

}  // namespace pliant
