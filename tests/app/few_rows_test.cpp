// An instrument's file whose tables have three rows each is fitted to the end: its report shows
// curves and says that they are not determined.

#include <filesystem>

#include <gtest/gtest.h>

#include "app/run_program.h"
#include "io/temporary_folder.h"

namespace pliant::test {
namespace {

TEST(FewRows, AreFittedAndReported) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_program({"fit", PLIANT_SOURCE_DIR "/tests/corpus/u3m/two_directions.json", "-o",
                   (folder.path() / "fit").string()});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "fit/report.html"));
}

}  // namespace
}  // namespace pliant::test
