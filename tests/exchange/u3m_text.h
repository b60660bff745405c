#pragma once

#include <string>

#include <fmt/format.h>

namespace pliant::test {

// Made-up U3M records.

inline constexpr char kStretch[] = "[[8.0, 0, 8.5, 10, 9.0, 30], [8.9, 20, 8.4, 2, 8.05, 0]]";

struct TestText {
  std::string length = "8.0";
  std::string tree = kStretch;
  std::string more = R"("freq": 50, "width": 5, "time": 1000000000)";
};

inline std::string test_json(const TestText& text = {}) {
  return fmt::format(R"({{"length": {}, "samplesTree": {}, {}}})", text.length, text.tree,
                     text.more);
}

inline std::string record(const std::string& raw_data, const std::string& custom = "null") {
  return fmt::format("{{\"schema\": \"1.1\",\n\"custom\": {},\n\"raw_data\": {}}}", custom,
                     raw_data);
}

/// A record with one test, S2 along the warp.
inline std::string record_with(const TestText& text) {
  return record(fmt::format(R"({{"M": 150, "L": {{"S2": {}}}}})", test_json(text)));
}

}  // namespace pliant::test
