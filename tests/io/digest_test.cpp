#include "pliant/io/digest.h"

#include <string>

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

// FIPS 180-2, appendix B.
constexpr const char* kDigestOfAbc =
    "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* kDigestOfAMillionA =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

TEST(Sha256, AgreesWithThePublishedExamples) {
  EXPECT_EQ(sha256_of("abc"), kDigestOfAbc);
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')), kDigestOfAMillionA);
}

TEST(Sha256, OfAFileIsThatOfItsBytes) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("a", std::string(1'000'000, 'a'))), kDigestOfAMillionA);
  EXPECT_EQ(sha256_of_file(folder.write("b", "")), sha256_of(""));
  test::input_error_of([&] { sha256_of_file(folder.path() / "none"); });
  test::input_error_of([&] { sha256_of_file(folder.path()); });
}

TEST(Sha256, OfAFolderChangesWithEveryNameAndByteInIt) {
  const test::TemporaryFolder folder;
  folder.write("session/a.csv", "1");
  folder.write("session/frames/b.ply", "2");
  const std::string before = sha256_of_path(folder.path() / "session");
  EXPECT_EQ(sha256_of_path(folder.path() / "session"), before);
  folder.write("session/frames/b.ply", "3");
  const std::string other = sha256_of_path(folder.path() / "session");
  EXPECT_NE(other, before);
  std::filesystem::rename(folder.path() / "session/a.csv", folder.path() / "session/c.csv");
  EXPECT_NE(sha256_of_path(folder.path() / "session"), other);
}

}  // namespace
}  // namespace pliant
