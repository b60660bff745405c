#include "pliant/experiment/profile/virtual_profiles.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/experiment/profile/strip_rests.h"
#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

// Finer than a fit takes them.
constexpr int kElements = 48;
constexpr double kAccuracy = 1e-6;  // of a release (rad)

Eigen::Vector2d seen(const Eigen::Vector2d& point, const Instrument& instrument,
                     RandomStream& random) {
  const double x =
      measured(point.x(), instrument.length_noise, instrument.length_resolution, random);
  const double y =
      measured(point.y(), instrument.length_noise, instrument.length_resolution, random);
  return {x, y};
}

// Each as likely as the others.
std::size_t chosen(StripRests& rests, RandomStream& random) {
  const std::size_t count = 1 + rests.others().size();
  const auto share = static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  return std::min(share, count - 1);
}

}  // namespace

std::string VirtualProfiles::rows(const ComponentLaw& law, const ClothFacts& cloth,
                                  RandomStream& random) const {
  const std::vector<std::string> header{setting_column(), "repeat", "point", "x_mm", "y_mm"};
  CsvWriter csv(header);
  for (const double setting : settings) {
    const Strip own = strip(setting);
    const Elastica line(own.length, kElements);
    const auto hanging = hanging_strip({&line}, law, own.rolled, cloth.density * kStandardGravity,
                                       /*with_derivatives=*/false, kAccuracy);
    if (!hanging) {
      fail(fmt::format("the strip at {:.4g} mm finds no equilibrium; its profile", setting * 1e3));
    }
    StripRests rests(*hanging, law, own.rolled, cloth.density * kStandardGravity);
    for (int repeat = 1; repeat <= repeats; ++repeat) {
      const StripProfile profile = rests.profile(any_rest ? chosen(rests, random) : 0, false);
      for (int i = 0; i < points; ++i) {
        Eigen::Vector2d point = Eigen::Vector2d::Zero();  // the clamp
        if (i > 0) {
          point = seen(profile.at(own.length * i / (points - 1)).position, instrument, random);
        }
        csv.cell(setting * 1e3).cell(repeat).cell(i).cell(point.x() * 1e3).cell(point.y() * 1e3);
        csv.end_row();
      }
    }
  }
  return csv.text();
}

WrittenFields VirtualProfiles::study_fields() const {
  return {{"direction", direction}, {"width", fmt::format("{} m", width)}};
}

std::string VirtualProfiles::profiles_text() const {
  return sequence_text(settings, Dimension::length, fmt::format(", {} points a profile", points));
}

void read_photographs(Fields& fields, VirtualProfiles& test) {
  if (auto v = fields.optional("points")) test.points = v->integer(5, 1000);
  read_repeats(fields, test);
  read_instrument(fields, test);
}

}  // namespace pliant
