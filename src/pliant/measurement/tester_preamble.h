#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// Something that a testing machine wrote above its table.
struct TesterFact {
  std::string field;    ///< length, width, pretension, speed, direction, material, specimen,
                        ///< operator, date or standard
  std::string value;    ///< as a study writes it: "100 mm", "warp", "KL"
  std::string written;  ///< the whole line of the file
  int line = 0;
};

/// What is known of the words of testing machines, English and German, in the lines above a table:
/// `Gauge length;100;mm`, `Probenbreite: 50,0 mm`, `"Width (mm)","50"`. Each field once, by its
/// first line that tells it; a size that names no unit is not told. Without a line on the direction
/// the name of the specimen or of the fabric may tell it.
std::vector<TesterFact> tester_facts(std::string_view preamble);

/// The fact of a field; null where there is none.
const TesterFact* find_fact(std::span<const TesterFact> facts, std::string_view field);

/// The direction that a text names by a word of its own, as in `kette_03.csv`: warp, weft or bias;
/// empty where it names none, or several.
std::string told_direction(std::string_view text);

}  // namespace pliant
