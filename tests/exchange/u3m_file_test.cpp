#include "pliant/exchange/u3m_file.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include "pliant/exchange/u3m_import.h"

#include "exchange/u3m_text.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::record;
using test::record_with;
using test::TemporaryFolder;
using test::test_json;
using ::testing::HasSubstr;

using Files = std::vector<std::pair<std::string, std::string>>;

Files files_of(const std::string& text) {
  const TemporaryFolder folder;
  return import_u3m(folder.write("fabric.json", text)).files;
}

std::filesystem::path write_zip(const TemporaryFolder& folder, const std::string& name,
                                const Files& files) {
  const std::filesystem::path path = folder.path() / name;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto& [entry, content] : files) {
    zip_file_add(archive, entry.c_str(),
                 zip_source_buffer(archive, content.data(), content.size(), 0), 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  return path;
}

constexpr char kMaterial[] =
    R"({"schema": "1.1", "custom": null, "material": {"name": "Poplin 12", "physics": {
        "thickness": 0.3, "weight": 120, "devices": {"fab": "physics/fab.json"},
        "construction": {"type": "Poplin", "name": null},
        "composition": {"parts": [{"type": "Cotton", "ratio": 0.65, "name": null},
                                  {"type": "Polyester", "ratio": 0.35, "name": null}]}}}})";

TEST(U3mFile, MeasurementsMayStandUnderPhysics) {
  const std::string inner = record_with({});
  for (const std::string& text : {fmt::format(R"({{"physics": {}}})", inner),
                                  fmt::format(R"({{"material": {{"physics": {}}}}})", inner)}) {
    EXPECT_EQ(files_of(text), files_of(inner));
  }
}

TEST(U3mFile, AMaterialDescriptionLeadsToItsPhysicsFile) {
  const TemporaryFolder folder;
  folder.write("physics/fab.json", record(fmt::format(R"({{"L": {{"S2": {}}}}})", test_json())));
  const ImportedStudy imported = import_u3m(folder.write("poplin.u3m", kMaterial));
  EXPECT_THAT(imported.study_yaml, HasSubstr("name: \"Poplin 12\""));
  EXPECT_THAT(imported.study_yaml, HasSubstr("density: 120 g/m^2"));
  EXPECT_THAT(imported.study_yaml, HasSubstr("composition: \"Cotton 65 %, Polyester 35 %\""));
  EXPECT_THAT(imported.study_yaml, HasSubstr("source: \"poplin.u3m"));
}

TEST(U3mFile, ArchivesAreSearchedForThePhysicsFile) {
  const TemporaryFolder folder;
  const std::string physics = record_with({});
  const auto described =
      write_zip(folder, "a.u3ma", {{"m/poplin.u3m", kMaterial}, {"m/physics/fab.json", physics}});
  const auto bare = write_zip(folder, "b.u3m", {{"other.json", "{}"}, {"deep/any.json", physics}});
  EXPECT_TRUE(is_u3m(described));
  EXPECT_EQ(import_u3m(described).files, files_of(physics));
  EXPECT_EQ(import_u3m(bare).files, files_of(physics));
}

TEST(U3mFile, APhysicsFileOutsideOfTheMaterialsFolderIsRefused) {
  const TemporaryFolder folder;
  folder.write("fab.json", record_with({}));
  for (const char* path : {"../fab.json", "/etc/fab.json", "a/../../fab.json"}) {
    const auto file = folder.write(
        "m/poplin.u3m",
        fmt::format(R"({{"material": {{"physics": {{"devices": {{"fab": "{}"}}}}}}}})", path));
    EXPECT_THAT(input_error_of([&] { import_u3m(file); }).problem(),
                HasSubstr("leads out of the folder"));
  }
}

TEST(IsU3m, TellsU3mFilesFromStudies) {
  const TemporaryFolder folder;
  const std::string whole = record_with({});
  EXPECT_TRUE(is_u3m(folder.write("fabric.json", whole)));
  EXPECT_TRUE(is_u3m(folder.write("mark.json", "\xEF\xBB\xBF \n" + whole)));
  EXPECT_TRUE(is_u3m(folder.write("truncated.json", whole.substr(0, whole.size() / 2))));
  EXPECT_TRUE(is_u3m(folder.write("poplin.json", kMaterial)));
  EXPECT_TRUE(is_u3m(folder.write("any.U3M", "")));
  EXPECT_FALSE(is_u3m(folder.write("study.yaml", "pliant: study/1\nname: raw_data\n")));
  EXPECT_FALSE(is_u3m(folder.write("study.json", R"({"pliant": "study/1", "name": "a"})")));
  EXPECT_FALSE(is_u3m(
      folder.write("other.json", R"({"pliant": "scene/1", "schema": "1.1", "material": {}})")));
  EXPECT_FALSE(is_u3m(folder.write("list.json", "[]")));
  EXPECT_FALSE(is_u3m(folder.write("empty.json", "")));
  EXPECT_THROW(is_u3m(folder.path() / "none.json"), InputError);
  EXPECT_THROW(is_u3m(folder.path()), InputError);
}

}  // namespace
}  // namespace pliant
