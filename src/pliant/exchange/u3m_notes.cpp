#include "pliant/exchange/u3m_notes.h"

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <optional>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

constexpr int kDigits = 4;
constexpr const char* kDirections[] = {"warp", "weft", "bias"};

/// The unit in which strips are cut and the file counts.
std::string width_text(const std::optional<double>& metres) {
  return metres ? format_number(100 * *metres, kDigits) + " cm" : "no width";
}

std::string utc_text(std::int64_t time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(time)));
}

template <typename Texts>
std::string joined(const Texts& texts) {
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The dated tests of a direction, oldest first.
std::vector<const U3mTest*> dated_tests(const std::vector<ImportedTest>& tests,
                                        const std::string& direction) {
  std::vector<const U3mTest*> dated;
  for (const ImportedTest& imported : tests) {
    if (imported.direction == direction && imported.test.time) dated.push_back(&imported.test);
  }
  std::stable_sort(dated.begin(), dated.end(),
                   [](const U3mTest* a, const U3mTest* b) { return *a->time < *b->time; });
  return dated;
}

std::string order_text(const std::vector<const U3mTest*>& dated) {
  std::vector<std::string> names;
  for (const U3mTest* test : dated) names.push_back(test->name);
  return joined(names);
}

/// "55 Hz" of the tests that `chosen` takes; empty when none tells its rate.
template <typename Chosen>
std::string sampling_text(const std::vector<ImportedTest>& tests, Chosen chosen) {
  std::vector<std::string> rates;
  for (const ImportedTest& imported : tests) {
    if (!imported.test.frequency || !chosen(imported.test)) continue;
    const std::string rate = format_number(*imported.test.frequency, kDigits) + " Hz";
    if (std::find(rates.begin(), rates.end(), rate) == rates.end()) rates.push_back(rate);
  }
  return joined(rates);
}

bool is_stretch(const U3mTest& test) { return test.kind == U3mTestKind::stretch; }

std::string thickness_text(const U3mThickness& thickness) {
  return fmt::format("{} mm at {} N, first contact (the pressed area is not in the file)",
                     format_number(1e3 * thickness.distance, kDigits),
                     format_number(thickness.force, kDigits));
}

std::size_t row_count(const U3mTest& test) {
  std::size_t rows = 0;
  for (const U3mSegment& segment : test.segments) rows += segment.force.size();
  return rows;
}

/// "78.6 mm to 130 mm" of the samples of all segments.
std::string range_text(const U3mTest& test, std::vector<double> U3mSegment::*samples,
                       Dimension dimension) {
  std::vector<double> all;
  for (const U3mSegment& segment : test.segments) {
    all.insert(all.end(), (segment.*samples).begin(), (segment.*samples).end());
  }
  const auto [lowest, highest] = std::minmax_element(all.begin(), all.end());
  return fmt::format("{} to {}", format_quantity(*lowest, dimension, kDigits),
                     format_quantity(*highest, dimension, kDigits));
}

std::string test_note(const ImportedTest& imported) {
  const U3mTest& test = imported.test;
  const std::size_t half_cycles = test.segments.size();
  return fmt::format(
      "{}: {} rows in {} half cycles{}, clamp distance {} (straight at {}), force {}",
      imported.name, row_count(test), half_cycles,
      half_cycles % 2 == 0 ? "" : " (the last cycle does not return)",
      range_text(test, &U3mSegment::distance, Dimension::length),
      format_quantity(test.length, Dimension::length, kDigits),
      range_text(test, &U3mSegment::force, Dimension::force));
}

std::vector<std::string> width_notes(const std::vector<ImportedTest>& tests,
                                     const ImportOptions& options) {
  std::map<std::optional<double>, std::vector<std::string>> names;  // by the file's width
  for (const ImportedTest& imported : tests) names[imported.test.width].push_back(imported.name);
  std::vector<std::string> notes;
  for (const auto& [width, group] : names) {
    const std::string which = names.size() == 1 ? "" : ": " + joined(group);
    notes.push_back(
        options.width_m
            ? fmt::format("strip width {} (as given; the file tells {}){}",
                          width_text(options.width_m), width_text(width), which)
            : fmt::format("strip width {} (from the file){}", width_text(width), which));
  }
  return notes;
}

std::optional<std::int64_t> time_of(const std::vector<const U3mTest*>& dated,
                                    const std::string& name) {
  for (const U3mTest* test : dated) {
    if (test->name == name) return test->time;
  }
  return std::nullopt;
}

std::vector<std::string> order_notes(const std::vector<ImportedTest>& tests) {
  std::vector<std::string> notes;
  for (const char* direction : kDirections) {
    const std::vector<const U3mTest*> dated = dated_tests(tests, direction);
    if (dated.size() < 2) continue;
    notes.push_back(fmt::format("{}: tested in the order {}", direction, order_text(dated)));
    const auto far = time_of(dated, "stretch-8cm");
    const auto near = time_of(dated, "stretch-2cm");
    if (!far || !near || *near <= *far) continue;
    notes.push_back(fmt::format(
        "{0}: stretch-2cm came {1} s after stretch-8cm; on the same strip, it was stretched before "
        "(`after: {0}-stretch-8cm` follows it)",
        direction, *near - *far));
  }
  return notes;
}

/// Whether the clamps move apart (1) or together (-1) over a segment; 0 when they end where they
/// were.
int movement(const U3mSegment& segment) {
  if (segment.distance.empty()) return 0;
  const double way = segment.distance.back() - segment.distance.front();
  return (way > 0) - (way < 0);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> conduct_entries(
    const std::vector<ImportedTest>& tests, const U3mPhysics& physics) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const std::string direction : kDirections) {
    const std::vector<const U3mTest*> dated = dated_tests(tests, direction);
    if (dated.empty()) continue;
    entries.emplace_back(
        "tested_" + direction,
        fmt::format("{} to {}", utc_text(*dated.front()->time), utc_text(*dated.back()->time)));
    entries.emplace_back("order_" + direction, order_text(dated));
  }
  if (std::string text = sampling_text(tests, is_stretch); !text.empty()) {
    entries.emplace_back("sampling_stretch", std::move(text));
  }
  if (std::string text = sampling_text(tests, std::not_fn(is_stretch)); !text.empty()) {
    entries.emplace_back("sampling_bend", std::move(text));
  }
  if (physics.thickness) entries.emplace_back("thickness", thickness_text(*physics.thickness));
  return entries;
}

std::vector<std::string> import_notes(const std::vector<ImportedTest>& tests,
                                      const U3mPhysics& physics, const ImportOptions& options) {
  std::vector<std::string> notes;
  if (physics.density > 0) {
    notes.push_back("mass per area " +
                    format_quantity(physics.density, Dimension::area_density, kDigits));
  }
  for (std::string& note : width_notes(tests, options)) notes.push_back(std::move(note));
  if (physics.thickness) notes.push_back("thickness " + thickness_text(*physics.thickness));
  for (const ImportedTest& test : tests) notes.push_back(test_note(test));
  for (std::string& note : order_notes(tests)) notes.push_back(std::move(note));
  notes.push_back(options.without_pauses
                      ? "times of the stretch tests are those of the sampling rate, as if half "
                        "cycles followed each other at once (--no-pauses)"
                      : "no time column: the file tells a sampling rate but not the pauses between "
                        "half cycles");
  return notes;
}

std::vector<std::string> segment_warnings(const std::vector<ImportedTest>& tests) {
  std::vector<std::string> warnings;
  for (const ImportedTest& imported : tests) {
    const std::vector<U3mSegment>& segments = imported.test.segments;
    for (std::size_t i = 1; i < segments.size(); ++i) {
      const int now = movement(segments[i]);
      if (now != 0 && now != movement(segments[i - 1])) continue;
      warnings.push_back(fmt::format(
          "{}: half cycle {} does not go back where {} came from; cycles are numbered by pairs",
          imported.name, i + 1, i));
      break;
    }
  }
  return warnings;
}

}  // namespace pliant
