#include "pliant/io/result_directory.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/result_manifest.h"

#include "input_error_of.h"
#include "limited_process.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::FileSizeLimit;
using test::input_error_of;
using test::TemporaryFolder;
using test::WithoutRootRights;

int entries_in(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void make_results(const fs::path& folder, const std::string& command,
                  const std::vector<std::string>& names) {
  ResultDirectory results(folder, command);
  for (const std::string& name : names) results.write(name, command + " " + name);
  results.commit();
}

TEST(ResultDirectory, AppearsCompleteOnCommit) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "a" / "b";
  {
    ResultDirectory results(out, "fit");
    results.write("fit.json", "{}");
    results.write("predictions/warp.csv", "a\n1\n");
    EXPECT_FALSE(fs::exists(out / "fit.json"));
    results.commit();
  }
  EXPECT_EQ(content_of(out / "fit.json"), "{}");
  EXPECT_EQ(content_of(out / "predictions/warp.csv"), "a\n1\n");
  EXPECT_NE(content_of(out / ".pliant-results.json").find("\"predictions/warp.csv\""),
            std::string::npos);
  EXPECT_EQ(entries_in(out), 3);  // no staging folder is left
}

TEST(ResultDirectory, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  {
    ResultDirectory results(folder.path() / "a" / "b", "fit");
    results.write("predictions/warp.csv", "1");
  }
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
}

TEST(ResultDirectory, KeepsEarlierResultsWithoutCommit) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  make_results(out, "fit", {"fit.json"});
  {
    ResultDirectory results(out, "fit");
    results.write("fit.json", "half");
  }
  EXPECT_EQ(content_of(out / "fit.json"), "fit fit.json");
  EXPECT_EQ(entries_in(out), 2);
}

TEST(ResultDirectory, ReplacesEarlierResultsOfTheSameCommand) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json", "predictions/a.csv", "predictions/b.csv", "x/y"});
  make_results(folder.path(), "fit", {"fit.json", "predictions/b.csv", "x"});
  EXPECT_TRUE(fs::exists(folder.path() / "fit.json"));
  EXPECT_FALSE(fs::exists(folder.path() / "predictions/a.csv"));
  EXPECT_TRUE(fs::exists(folder.path() / "predictions/b.csv"));
  EXPECT_TRUE(fs::is_regular_file(folder.path() / "x"));
  make_results(folder.path(), "fit", {"fit.json"});
  EXPECT_FALSE(fs::exists(folder.path() / "predictions"));
}

TEST(ResultDirectory, LeavesWhatTheUserPutBesideResults) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json"});
  folder.write("notes/mine.txt", "precious");
  make_results(folder.path(), "fit", {"fit.json", "report.html"});
  EXPECT_EQ(content_of(folder.path() / "notes/mine.txt"), "precious");
  EXPECT_TRUE(fs::exists(folder.path() / "report.html"));
}

TEST(ResultDirectory, NeverWritesOverWhatTheUserPutBesideResults) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json"});
  folder.write("report.html", "precious");
  const InputError error = input_error_of([&] {
    make_results(folder.path(), "fit", {"fit.json", "report.html"});
  });
  EXPECT_EQ(error.problem(), "holds a file that no \"fit\" wrote: \"report.html\"");
  EXPECT_EQ(content_of(folder.path() / "report.html"), "precious");
}

TEST(ResultDirectory, RefusesAtOnceWhatStandsAmongItsResults) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json", "predictions/a.csv"});
  folder.write("predictions/new.csv", "precious");
  const InputError error = input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
  EXPECT_EQ(error.problem(), "holds a file that no \"fit\" wrote: \"predictions/new.csv\"");
}

TEST(ResultDirectory, OwnsWhatIsListedLater) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json"});
  folder.write("report.html", "of a later command");
  list_result(folder.path(), "report.html");
  make_results(folder.path(), "fit", {"fit.json", "report.html"});
  EXPECT_EQ(content_of(folder.path() / "report.html"), "fit report.html");
}

TEST(ResultDirectory, RefusesAFolderWithoutResultsThatHoldsAnythingElseAndNamesIt) {
  const TemporaryFolder folder;
  folder.write("notes/mine.txt", "precious");
  const InputError error = input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
  EXPECT_EQ(error.where().file, folder.path().string());
  EXPECT_EQ(error.problem(), "holds a file that no \"fit\" wrote: \"notes/mine.txt\"");
  EXPECT_EQ(content_of(folder.path() / "notes/mine.txt"), "precious");
  EXPECT_EQ(entries_in(folder.path()), 1);
}

TEST(ResultDirectory, OwnsOnlyWhatItsLatestRunWrote) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json", "old.csv"});
  make_results(folder.path(), "fit", {"fit.json"});
  folder.write("old.csv", "the user's own by now");
  input_error_of([&] { make_results(folder.path(), "fit", {"fit.json", "old.csv"}); });
}

TEST(ResultDirectory, RefusesASymbolicLinkThatIsNotItsOwn) {
  const TemporaryFolder folder;
  fs::create_symlink("nowhere", folder.path() / "link");
  const InputError error = input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
  EXPECT_EQ(error.problem(), "holds a file that no \"fit\" wrote: \"link\"");
}

TEST(ResultDirectory, RefusesResultsOfAnotherCommand) {
  const TemporaryFolder folder;
  make_results(folder.path(), "lab", {"study.yaml"});
  const InputError error = input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
  EXPECT_EQ(error.problem(), "holds results of \"lab\"");
}

TEST(ResultDirectory, TrustsNoListThatNamesFilesOutsideTheFolder) {
  const TemporaryFolder folder;
  folder.write("victim", "precious");
  for (const char* name : {"../victim", "/etc/passwd", "a/../../victim", ".", ""}) {
    folder.write(
        "out/.pliant-results.json",
        std::string(R"({"pliant": "results/1", "command": "fit", "files": [")") + name + "\"]}");
    input_error_of([&] { ResultDirectory(folder.path() / "out", "fit"); });
  }
  folder.write("out/.pliant-results.json", "{");
  EXPECT_EQ(input_error_of([&] { ResultDirectory(folder.path() / "out", "fit"); }).where().line, 1);
  EXPECT_EQ(content_of(folder.path() / "victim"), "precious");
}

TEST(ResultDirectory, TakesARelativeNameWithATrailingSlash) {
  const TemporaryFolder folder;
  make_results(folder.path() / "out/", "fit", {"fit.json"});
  EXPECT_TRUE(fs::exists(folder.path() / "out/fit.json"));
}

TEST(ResultDirectory, RefusesAPathThatCannotBeAFolder) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "");
  EXPECT_EQ(input_error_of([&] { ResultDirectory(file, "fit"); }).where().file, file.string());
  input_error_of([&] { ResultDirectory(file / "out", "fit"); });
  input_error_of([] { ResultDirectory("/proc/self/out", "fit"); });
}

TEST(ResultDirectory, RefusesAFolderWithoutWritePermission) {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms(0555));
  {
    const WithoutRootRights nobody;
    input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
    input_error_of([&] { ResultDirectory(folder.path() / "out", "fit"); });
    input_error_of([&] { write_file_atomically(folder.path() / "a", "1"); });
  }
  fs::permissions(folder.path(), fs::perms(0755));
  EXPECT_EQ(entries_in(folder.path()), 0);
}

TEST(ResultDirectory, IsWrittenByOneRunAtATime) {
  const TemporaryFolder folder;
  const ResultDirectory first(folder.path(), "fit");
  const InputError error = input_error_of([&] { ResultDirectory(folder.path(), "fit"); });
  EXPECT_NE(error.problem().find("another run"), std::string::npos);
}

TEST(ResultDirectory, RemovesWhatAKilledRunLeft) {
  const TemporaryFolder folder;
  folder.write(".pliant-partial-1/predictions/a.csv", "half");
  make_results(folder.path(), "fit", {"fit.json"});
  EXPECT_EQ(entries_in(folder.path()), 2);
}

TEST(ResultDirectory, LeavesNothingHalfWrittenWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  {
    ResultDirectory results(out, "fit");
    results.write("small", "1");
    const FileSizeLimit limit(1000);
    try {
      results.write("large", std::string(5000, 'x'));
      FAIL() << "the disk was not full";
    } catch (const OutputError& error) {
      EXPECT_EQ(error.path(), (out / "large").string());
    }
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST(ResultDirectory, KeepsEarlierResultsWhenTheDiskIsFullAtCommit) {
  const TemporaryFolder folder;
  make_results(folder.path(), "fit", {"fit.json"});
  {
    ResultDirectory results(folder.path(), "fit");
    results.write("fit.json", "new");
    const FileSizeLimit limit(10);
    EXPECT_THROW(results.commit(), OutputError);
  }
  EXPECT_EQ(content_of(folder.path() / "fit.json"), "fit fit.json");
  EXPECT_EQ(entries_in(folder.path()), 2);
}

TEST(ResultDirectory, TakesSafeNamesOnceOnly) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path(), "fit");
  EXPECT_THROW(results.write("../a", ""), AssertionError);
  EXPECT_THROW(results.write("/a", ""), AssertionError);
  results.write("a", "");
  EXPECT_THROW(results.write("a", ""), AssertionError);
}

using Names = std::vector<std::string>;

/// Names in the hidden list of results, in its order.
Names listed_files(const fs::path& folder) {
  const auto manifest = read_manifest(folder);
  if (!manifest) return {};
  return {manifest->files.begin(), manifest->files.end()};
}

TEST(ResultDirectoryPublish, PutsWhatIsThereIntoPlaceAgainAndAgain) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path() / "out", "simulate");
  results.write("frames/0.ply", "first");
  results.write("simulation.json", "1 frame");
  results.publish();
  EXPECT_EQ(content_of(results.path() / "frames/0.ply"), "first");
  EXPECT_EQ(listed_files(results.path()), (Names{"frames/0.ply", "simulation.json"}));

  results.write("frames/1.ply", "second");
  results.write("simulation.json", "2 frames");
  EXPECT_FALSE(fs::exists(results.path() / "frames/1.ply"));
  EXPECT_EQ(content_of(results.path() / "simulation.json"), "1 frame");
  results.commit();
  EXPECT_EQ(content_of(results.path() / "frames/0.ply"), "first");
  EXPECT_EQ(content_of(results.path() / "frames/1.ply"), "second");
  EXPECT_EQ(content_of(results.path() / "simulation.json"), "2 frames");
  EXPECT_EQ(listed_files(results.path()),
            (Names{"frames/0.ply", "frames/1.ply", "simulation.json"}));
  EXPECT_EQ(entries_in(results.path()), 3);  // no staging folder is left
}

TEST(ResultDirectoryPublish, StaysWhenTheRunEndsWithoutCommit) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  {
    ResultDirectory results(out, "simulate");
    results.write("a", "published");
    results.publish();
    results.write("a", "half");
    results.write("b", "half");
  }
  EXPECT_EQ(content_of(out / "a"), "published");
  EXPECT_EQ(listed_files(out), Names{"a"});
  EXPECT_EQ(entries_in(out), 2);
}

TEST(ResultDirectoryPublish, RemovesEarlierResultsTheFirstTime) {
  const TemporaryFolder folder;
  make_results(folder.path(), "simulate", {"frames/0.ply", "frames/1.ply", "energy.csv"});
  ResultDirectory results(folder.path(), "simulate");
  results.write("frames/0.ply", "new");
  EXPECT_TRUE(fs::exists(folder.path() / "energy.csv"));
  results.publish();
  EXPECT_EQ(content_of(folder.path() / "frames/0.ply"), "new");
  EXPECT_FALSE(fs::exists(folder.path() / "frames/1.ply"));
  EXPECT_FALSE(fs::exists(folder.path() / "energy.csv"));
  EXPECT_EQ(listed_files(folder.path()), Names{"frames/0.ply"});
}

TEST(ResultDirectoryPublish, LeavesEverythingAsItWasWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path() / "out", "simulate");
  results.write("a", "old");
  results.publish();
  results.write("a", "new");
  {
    const FileSizeLimit limit(10);
    EXPECT_THROW(results.publish(), OutputError);
  }
  EXPECT_EQ(content_of(results.path() / "a"), "old");
  EXPECT_EQ(listed_files(results.path()), Names{"a"});
}

TEST(ResultDirectoryPublish, PutsFilesIntoPlaceInTheOrderInWhichTheyWereWritten) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "in-the-way");
  ResultDirectory results(folder.path(), "simulate");
  for (const char* name : {"z", "in-the-way", "a"}) results.write(name, "1");
  EXPECT_THROW(results.publish(), OutputError);
  EXPECT_TRUE(fs::exists(folder.path() / "z"));
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
}

TEST(ResultDirectoryPublish, IsNotPossibleAfterCommit) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path(), "simulate");
  results.commit();
  EXPECT_THROW(results.publish(), AssertionError);
  EXPECT_THROW(results.grow("a"), AssertionError);
}

TEST(ResultDirectorySetAside, StandsBesideEarlierResultsUntilThereAreNewOnes) {
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "results";
  make_results(results, "fit", {"fit.json"});
  {
    ResultDirectory stopped(results, "fit");
    stopped.write("fit.json", "half");
    stopped.set_aside("progress.bin", "one");
    stopped.set_aside("progress.bin", "two");
  }
  EXPECT_EQ(content_of(results / "progress.bin"), "two");
  EXPECT_EQ(content_of(results / "fit.json"), "fit fit.json");
  make_results(results, "fit", {"fit.json"});
  EXPECT_FALSE(fs::exists(results / "progress.bin"));
}

TEST(ResultDirectorySetAside, StaysWhereThereIsNothingElse) {
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "results";
  ResultDirectory(results, "fit").set_aside("progress.bin", "one");
  EXPECT_EQ(content_of(results / "progress.bin"), "one");
  make_results(results, "fit", {"fit.json"});
  EXPECT_FALSE(fs::exists(results / "progress.bin"));
}

TEST(ResultDirectoryGrow, GivesAPlaceThatBelongsToTheResultsAtOnce) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  {
    ResultDirectory results(out, "simulate");
    const fs::path file = results.grow("cache/cloth.pc2");
    EXPECT_EQ(file, out / "cache/cloth.pc2");
    EXPECT_EQ(listed_files(out), Names{"cache/cloth.pc2"});
    std::ofstream(file) << "grown";
  }
  // The run has died, and the next one may replace what it left.
  EXPECT_EQ(content_of(out / "cache/cloth.pc2"), "grown");
  make_results(out, "simulate", {"energy.csv"});
  EXPECT_FALSE(fs::exists(out / "cache"));
}

TEST(ResultDirectoryGrow, StaysWhereItIsAtCommit) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path(), "simulate");
  std::ofstream(results.grow("cloth.pc2")) << "grown";
  results.write("energy.csv", "1");
  results.commit();
  EXPECT_EQ(content_of(folder.path() / "cloth.pc2"), "grown");
  EXPECT_EQ(listed_files(folder.path()), (Names{"cloth.pc2", "energy.csv"}));
}

TEST(ResultDirectoryGrow, TakesSafeNamesOnly) {
  const TemporaryFolder folder;
  ResultDirectory results(folder.path(), "simulate");
  EXPECT_THROW(results.grow("../a"), AssertionError);
}

TEST(ResultDirectoryKeep, AddsToEarlierResults) {
  const TemporaryFolder folder;
  make_results(folder.path(), "simulate", {"frames/0.ply", "energy.csv"});
  {
    ResultDirectory results(folder.path(), "simulate", ResultDirectory::Earlier::keep);
    results.write("frames/1.ply", "new");
    results.write("energy.csv", "new");
    results.commit();
  }
  EXPECT_EQ(content_of(folder.path() / "frames/0.ply"), "simulate frames/0.ply");
  EXPECT_EQ(content_of(folder.path() / "frames/1.ply"), "new");
  EXPECT_EQ(content_of(folder.path() / "energy.csv"), "new");
  EXPECT_EQ(listed_files(folder.path()), (Names{"energy.csv", "frames/0.ply", "frames/1.ply"}));
}

TEST(ResultDirectoryKeep, LeavesThemAsTheyWereWithoutCommit) {
  const TemporaryFolder folder;
  make_results(folder.path(), "simulate", {"energy.csv"});
  {
    ResultDirectory results(folder.path(), "simulate", ResultDirectory::Earlier::keep);
    results.write("energy.csv", "half");
  }
  EXPECT_EQ(content_of(folder.path() / "energy.csv"), "simulate energy.csv");
  EXPECT_EQ(listed_files(folder.path()), Names{"energy.csv"});
}

TEST(ResultDirectoryKeep, RefusesWhatIsNotOfTheSameCommand) {
  const TemporaryFolder folder;
  make_results(folder.path() / "fit", "fit", {"fit.json"});
  folder.write("foreign/mine.txt", "precious");
  for (const char* name : {"fit", "foreign"}) {
    input_error_of(
        [&] { ResultDirectory(folder.path() / name, "simulate", ResultDirectory::Earlier::keep); });
  }
}

TEST(ResultDirectoryKeep, LeavesNoFolderWhereThereWasNone) {
  const TemporaryFolder folder;
  { ResultDirectory(folder.path() / "out", "simulate", ResultDirectory::Earlier::keep); }
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace pliant
