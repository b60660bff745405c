// Fits of strips that were stopped go on to the same bits.

#include <string>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/study/result_files.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;

constexpr int kThreads = 2;

/// Weights along the warp and cycles along the weft, with noise: two components, side by side.
VirtualStudy two_components(std::uint64_t seed) {
  auto weights = hung_weights();
  weights.instrument.length_noise = 0.2e-3;
  auto cycles = strip_cycles({0.05, 0.1});
  cycles.direction = "weft";
  cycles.instrument.force_noise = 5e-3;
  Material fabric = published_fabric("polyester");
  fabric.components["stretch.weft"] = fabric.components.at("stretch.warp");
  return VirtualStudy(lab_of(fabric, {weights, cycles}), seed);
}

int answers_of(const Journal::Content& content) {
  std::size_t answers = content.entries.size();
  for (const auto& [name, entries] : content.parts) answers += entries.size();
  return static_cast<int>(answers);
}

/// Everything that a fit would write, its duration taken out.
std::string results_of(const Study& study, Journal& journal, StopToken stop = {}) {
  const StudyFitOptions everything{.compare_friction = true, .profiles = {"*"}};
  StudyResult result =
      fit_study(study, everything, {silent_progress(), stop, kThreads, 0, journal});
  result.seconds = 0;
  std::string text;
  for (const auto& [name, content] : fit_files(result, {})) text += name + "\n" + content;
  return text;
}

/// What a fit remembers when it is stopped after so many answers; those that are worked out on
/// another thread may come to it.
Journal::Content stopped_after(const Study& study, int answers) {
  StopFlag stop;
  int found = 0;
  Journal journal([&](const auto&) {
    if (++found == answers) stop.request();
  });
  EXPECT_THROW(results_of(study, journal, stop.token()), Interrupted);
  return journal.content();
}

TEST(SlowStripsResume, EndInTheSameBitsAndRepeatNoSearch) {
  const VirtualStudy files = two_components(1);
  const Study study = files.study();
  Journal journal([](const auto&) {});
  const std::string whole = results_of(study, journal);
  const int all = answers_of(journal.content());
  EXPECT_EQ(journal.content().parts.size(), 2u);
  for (const double share : {0.5, 0.95}) {
    const Journal::Content content = stopped_after(study, static_cast<int>(share * all));
    int worked_out = 0;
    Journal rest([&](const auto&) { ++worked_out; });
    rest.resume(content, "progress.bin");
    EXPECT_EQ(results_of(study, rest), whole) << share;
    EXPECT_EQ(worked_out, all - answers_of(content)) << share;
  }
}

TEST(StripsResume, RefuseTheProgressOfOtherDataAndOfAnotherStudy) {
  const Journal::Content content = stopped_after(two_components(1).study(), 20);
  const auto refused = [&](const VirtualStudy& files) {
    Journal rest([](const auto&) {});
    rest.resume(content, "progress.bin");
    try {
      results_of(files.study(), rest);
    } catch (const InputError& error) {
      return error.where().file == "progress.bin";
    }
    return false;
  };
  EXPECT_FALSE(refused(two_components(1))) << "the same data elsewhere";
  EXPECT_TRUE(refused(two_components(2)));
  VirtualStudy other = two_components(1);
  other.add("fit: {control_points: 3}");
  EXPECT_TRUE(refused(other));
}

}  // namespace
}  // namespace pliant
