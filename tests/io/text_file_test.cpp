#include "pliant/io/text_file.h"

#include <filesystem>
#include <string>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

TEST(ReadTextFile, GivesTheBytesOfAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_text_file(folder.write("a", "one\r\ntwo")), "one\r\ntwo");
  EXPECT_EQ(read_text_file(folder.write("b", "")), "");
}

TEST(ReadTextFile, RefusesADirectory) {
  const TemporaryFolder folder;
  const InputError error = input_error_of([&] { read_text_file(folder.path()); });
  EXPECT_EQ(error.where().file, folder.path().string());
  EXPECT_EQ(error.problem(), "is a directory");
}

TEST(ReadTextFile, RefusesAMissingFileDevicesAndPipes) {
  const TemporaryFolder folder;
  const auto missing = input_error_of([&] { read_text_file(folder.path() / "none"); });
  EXPECT_EQ(missing.problem(), "cannot be read: No such file or directory");
  EXPECT_EQ(input_error_of([] { read_text_file("/dev/zero"); }).problem(), "is not a regular file");
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(input_error_of([&] { read_text_file(pipe); }).problem(), "is not a regular file");
}

TEST(ReadTextFile, RefusesAGigabyteWithoutReadingIt) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("huge.csv", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30);  // sparse
  const InputError error = input_error_of([&] { read_text_file(file); });
  EXPECT_EQ(error.problem(), "the file is too large");
  EXPECT_EQ(error.expected(), "at most 256 MiB");
}

TEST(ReadTextFile, ReadsFilesWhoseSizeIsNotKnown) {
  EXPECT_NE(read_text_file("/proc/self/status").find("Pid:"), std::string::npos);
}

TEST(DecodeText, FollowsTheByteOrderMark) {
  EXPECT_EQ(decode_text("\xEF\xBB\xBFm\xC2\xB2", "", "f"), "m\xC2\xB2");
  EXPECT_EQ(decode_text(std::string("\xFF\xFEm\0\xB2\0", 6), "", "f"), "m\xC2\xB2");
  EXPECT_EQ(decode_text(std::string("\xFE\xFF\0m\0\xB2", 6), "", "f"), "m\xC2\xB2");
  EXPECT_EQ(decode_text("\xEF\xBB\xBFm", "latin1", "f"), "m");
}

TEST(DecodeText, ConvertsNamedEncodings) {
  EXPECT_EQ(decode_text("m\xB2", "latin1", "f"), "m\xC2\xB2");
  EXPECT_EQ(decode_text("\xC1\xA6", "gbk", "f"), "\xE5\x8A\x9B");  // force
  EXPECT_EQ(decode_text(std::string("m\0", 2), "utf-16le", "f"), "m");
}

TEST(DecodeText, NamesTheLineThatDoesNotFitTheEncoding) {
  const InputError error = input_error_of([] { decode_text("a\nb\nm\xB2\n", "", "f.csv"); });
  EXPECT_EQ(error.where().file, "f.csv");
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.problem(), "the text is not UTF-8");
  EXPECT_NE(error.expected().find("encoding:"), std::string::npos);
  input_error_of([] { decode_text("a\xC3", "", "f"); });  // cut within a character
}

TEST(DecodeText, RefusesUnknownEncodings) {
  EXPECT_EQ(input_error_of([] { decode_text("a", "klingon", "f"); }).problem(),
            "unknown encoding \"klingon\"");
  input_error_of([] { decode_text("a", "latin1//IGNORE", "f"); });
}

TEST(DecodeText, RefusesBinaryFilesAndUtf16WithoutItsMark) {
  const InputError error = input_error_of([] { decode_text(std::string("a\n\0b", 4), "", "f"); });
  EXPECT_EQ(error.where().line, 2);
  EXPECT_NE(error.expected().find("utf-16le"), std::string::npos);
}

}  // namespace
}  // namespace pliant
