#include "pliant/io/zip_file.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <zip.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

std::filesystem::path make_zip(const TemporaryFolder& folder,
                               const std::vector<std::pair<std::string, std::string>>& files,
                               zip_int32_t compression = ZIP_CM_DEFLATE) {
  const std::filesystem::path path = folder.path() / "a.zip";
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  zip_dir_add(archive, "folder/", 0);
  for (const auto& [name, content] : files) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t index = zip_file_add(archive, name.c_str(), source, 0);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), compression, 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  return path;
}

TEST(ZipFile, ListsAndReadsItsFiles) {
  const TemporaryFolder folder;
  const std::string large(300'000, 'x');
  const std::vector<std::pair<std::string, std::string>> files = {{"fabric.u3m", "{}"},
                                                                  {"folder/b", large}};
  const auto path = make_zip(folder, files);
  EXPECT_EQ(zip_entries(path), (std::vector<std::string>{"fabric.u3m", "folder/b"}));
  EXPECT_EQ(read_zip_entry(path, "fabric.u3m"), "{}");
  EXPECT_EQ(read_zip_entry(path, "folder/b"), large);
}

TEST(ZipFile, RefusesAnEntryThatIsNotThere) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files = {{"a", "1"}};
  const auto path = make_zip(folder, files);
  const InputError error = input_error_of([&] { read_zip_entry(path, "b"); });
  EXPECT_EQ(error.where().file, path.string());
  EXPECT_EQ(error.where().field, "b");
}

TEST(ZipFile, RefusesToUnpackMoreThanTheLimit) {
  const TemporaryFolder folder;
  const std::string zeros(10'000'000, '\0');
  const std::vector<std::pair<std::string, std::string>> files = {{"bomb", zeros}};
  const auto path = make_zip(folder, files);
  ASSERT_LT(std::filesystem::file_size(path), 100'000U);
  EXPECT_EQ(input_error_of([&] { read_zip_entry(path, "bomb", 1'000'000); }).problem(),
            "is too large when unpacked");
}

TEST(ZipFile, RefusesWhatIsNoArchive) {
  const TemporaryFolder folder;
  input_error_of([&] { zip_entries(folder.write("text", "no archive")); });
  input_error_of([&] { zip_entries(folder.write("empty", "")); });
  input_error_of([&] { zip_entries(folder.path() / "none"); });
  EXPECT_EQ(input_error_of([&] { zip_entries(folder.path()); }).problem(), "is a directory");
}

TEST(ZipFile, RefusesDamagedContent) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files = {{"a", "abcdefgh"}};
  std::string bytes = test::content_of(make_zip(folder, files, ZIP_CM_STORE));
  bytes[bytes.find("cdef")] = 'C';
  const auto damaged = folder.write("damaged.zip", bytes);
  input_error_of([&] { read_zip_entry(damaged, "a"); });
  const auto truncated = folder.write("truncated.zip", bytes.substr(0, bytes.size() / 2));
  input_error_of([&] { zip_entries(truncated); });
}

}  // namespace
}  // namespace pliant
