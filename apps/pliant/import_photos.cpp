#include "apps/pliant/import_photos.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/imaging/drape_import.h"
#include "pliant/imaging/photo.h"
#include "pliant/imaging/photo_import.h"

namespace pliant {
namespace {

double positive_quantity(const char* option, const std::string& text, Dimension dimension) {
  try {
    const double value = parse_quantity(text, dimension);
    if (value > 0) return value;
  } catch (const QuantityError& error) {
    throw InputError({option}, error.problem(), error.expected());
  }
  throw InputError({option}, quoted_value(text) + " is not positive", expected_quantity(dimension));
}

// Numbers between commas and, in sizes, the letter x.
std::vector<double> numbers_in(std::string text) {
  for (char& c : text) c = c == 'x' ? ',' : c;
  std::vector<double> numbers;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse_number(trimmed(std::string_view(text).substr(begin, end - begin)));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

Eigen::Vector2d read_pixel(const char* option, const std::string& text) {
  const std::vector<double> numbers = numbers_in(text);
  if (numbers.size() == 2) return {numbers[0], numbers[1]};
  throw InputError({option}, quoted_value(text) + " is no pixel",
                   "X,Y from the upper left of the photograph, e.g. 12,340");
}

PixelRegion read_region(const std::string& text) {
  constexpr double kLargest = 1e6;
  const std::vector<double> numbers = numbers_in(text);
  const bool sound =
      numbers.size() == 4 && std::all_of(numbers.begin(), numbers.end(), [](double n) {
        return n >= 0 && n < kLargest && n == std::floor(n);
      });
  if (sound) {
    const auto pixel = [&](size_t i) { return static_cast<int>(numbers[i]); };
    return {pixel(0), pixel(1), pixel(2), pixel(3)};
  }
  throw InputError({"--crop"}, quoted_value(text) + " is no region",
                   "X,Y,WIDTHxHEIGHT in pixels from the upper left, e.g. 40,0,1800x1200");
}

double read_density(const PhotoArguments& arguments) {
  if (arguments.density.empty() == arguments.areal_load.empty()) {
    throw InputError({"--density"}, arguments.density.empty() ? "is missing" : "is given twice",
                     "the mass per area, e.g. 180 g/m^2, or the weight per area as --areal-load, "
                     "e.g. 13.6 N/m^2");
  }
  if (!arguments.density.empty()) {
    return positive_quantity("--density", arguments.density, Dimension::area_density);
  }
  return positive_quantity("--areal-load", arguments.areal_load, Dimension::stress) /
         kStandardGravity;
}

double read_scale(const PhotoArguments& arguments, const char* place) {
  if (!arguments.scale.empty()) {
    return positive_quantity("--scale", arguments.scale, Dimension::length);
  }
  throw InputError({"--scale"}, "is missing",
                   fmt::format("the length of one pixel {}, e.g. \"0.11 mm\"", place));
}

StripPhotoOptions photo_options(const PhotoArguments& arguments) {
  StripPhotoOptions options;
  options.scale = read_scale(arguments, "in the plane of the strip");
  options.clamp_side = arguments.clamp_side == "right" ? ClampSide::right : ClampSide::left;
  if (!arguments.clamp.empty()) options.clamp = read_pixel("--clamp", arguments.clamp);
  if (!arguments.crop.empty()) options.region = read_region(arguments.crop);
  if (arguments.tone == "brighter") options.tone = StripTone::brighter;
  if (arguments.tone == "darker") options.tone = StripTone::darker;
  options.points = arguments.points;
  return options;
}

std::string fabric_name(const std::vector<std::filesystem::path>& photos,
                        const PhotoArguments& arguments) {
  return arguments.name.empty() ? photos.front().stem().string() : arguments.name;
}

void refuse_others(const std::vector<std::pair<const char*, const std::string*>>& options,
                   const char* kind) {
  for (const auto& [name, text] : options) {
    if (!text->empty())
      throw InputError({name}, fmt::format("is an option of {}", kind), "without");
  }
}

DrapeStudyOptions drape_options(const PhotoArguments& arguments) {
  refuse_others({{"--areal-load", &arguments.areal_load},
                 {"--direction", &arguments.direction},
                 {"--clamp", &arguments.clamp},
                 {"--width", &arguments.width}},
                "photographs of strips");
  DrapeStudyOptions options;
  options.photo.scale = read_scale(arguments, "at the height of the draped specimen");
  if (!arguments.specimen.empty()) {
    options.specimen = positive_quantity("--specimen", arguments.specimen, Dimension::length);
  }
  if (!arguments.disc.empty()) {
    options.photo.disc = positive_quantity("--disc", arguments.disc, Dimension::length);
  }
  const double least = least_specimen(options.photo.disc);
  if (options.specimen < least) {
    throw InputError({"--specimen"}, "hardly hangs over the disc",
                     "a diameter of at least " + format_quantity(least, Dimension::length));
  }
  if (!arguments.density.empty()) {
    options.density = positive_quantity("--density", arguments.density, Dimension::area_density);
  }
  if (!arguments.crop.empty()) options.photo.region = read_region(arguments.crop);
  if (!arguments.middle.empty()) options.photo.middle = read_pixel("--middle", arguments.middle);
  return options;
}

}  // namespace

ImportedStudy import_photo_files(const std::vector<std::string>& files,
                                 const PhotoArguments& arguments) {
  const std::vector<std::filesystem::path> photos(files.begin(), files.end());
  if (arguments.drape) {
    DrapeStudyOptions options = drape_options(arguments);
    options.name = fabric_name(photos, arguments);
    return import_drape_photos(photos, options);
  }
  refuse_others({{"--specimen", &arguments.specimen},
                 {"--disc", &arguments.disc},
                 {"--middle", &arguments.middle}},
                "--drape");
  PhotoStudyOptions options;
  options.photo = photo_options(arguments);
  options.density = read_density(arguments);
  if (arguments.direction.empty()) {
    throw InputError({"--direction"}, "is missing",
                     "the yarns that are bent, along the strip: warp, weft or bias");
  }
  options.direction = arguments.direction;
  if (!arguments.width.empty()) {
    options.width = positive_quantity("--width", arguments.width, Dimension::length);
  }
  options.name = fabric_name(photos, arguments);
  return import_photos(photos, options);
}

ReadPicture picture_reader() { return read_photo; }

}  // namespace pliant
