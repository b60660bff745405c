// Replays the inputs on which the fuzz targets start, and those on which they once failed.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/io/document.h"
#include "pliant/io/obj.h"
#include "pliant/io/ply.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus(const std::string& kind) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(PLIANT_SOURCE_DIR) / "tests/corpus" / kind)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Reads every file; tells how many were accepted. Anything but an InputError is a failure.
template <typename Read>
int count_accepted(const std::string& kind, Read&& read) {
  int accepted = 0;
  for (const fs::path& file : corpus(kind)) {
    SCOPED_TRACE(file.filename());
    try {
      read(file);
      ++accepted;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().file, file.string());
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  return accepted;
}

TEST(Corpus, CsvFilesAreReadOrRefused) {
  const int accepted = count_accepted("csv", [](const fs::path& file) {
    const CsvTable table = read_csv(file);
    EXPECT_GT(table.rows(), 0U);
    for (const std::string& header : table.headers()) {
      EXPECT_EQ(table.texts(header).size(), table.rows());
    }
  });
  EXPECT_GT(accepted, 0);
}

TEST(Corpus, YamlFilesAreReadOrRefused) {
  EXPECT_GT(count_accepted("yaml", [](const fs::path& file) { read_yaml(file); }), 0);
}

TEST(Corpus, JsonFilesAreReadOrRefused) {
  EXPECT_GT(count_accepted("json", [](const fs::path& file) { read_json(file); }), 0);
}

TEST(Corpus, PlyFilesAreReadOrRefused) {
  EXPECT_GT(count_accepted("ply", [](const fs::path& file) { read_ply(file); }), 0);
}

TEST(Corpus, ObjFilesAreReadOrRefused) {
  EXPECT_GT(count_accepted("obj", [](const fs::path& file) { read_obj(file); }), 0);
}

}  // namespace
}  // namespace pliant
