#include "pliant/io/pc2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::content_of;
using test::input_error_of;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<Point3> frame(double offset) { return {{offset, 1, 2}, {offset, 3, 4}}; }

TEST(Pc2, IsCompleteAfterEveryFrame) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.pc2";
  Pc2Writer writer(path, 2, 0.5);
  EXPECT_THAT(read_pc2(path).frames, SizeIs(0));
  for (int i = 0; i < 3; ++i) {
    writer.append(frame(i + 0.25));
    const Pc2Cache cache = read_pc2(path);
    EXPECT_EQ(cache.point_count, 2);
    EXPECT_EQ(cache.frame_step, 0.5);
    ASSERT_THAT(cache.frames, SizeIs(i + 1));
    EXPECT_EQ(cache.frames[i][0], (std::array<float, 3>{static_cast<float>(i) + 0.25f, 1, 2}));
    EXPECT_EQ(cache.frames[i][1], (std::array<float, 3>{static_cast<float>(i) + 0.25f, 3, 4}));
  }
}

TEST(Pc2, HasTheLayoutThatBlenderReads) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.pc2";
  Pc2Writer(path, 2).append(frame(0));
  const std::string bytes = content_of(path);
  EXPECT_THAT(bytes, SizeIs(32 + 2 * 12));
  EXPECT_EQ(bytes.substr(0, 24), std::string("POINTCACHE2\0\x01\0\0\0\x02\0\0\0\0\0\0\0", 24));
  EXPECT_EQ(bytes.substr(28, 4), std::string("\x01\0\0\0", 4));
}

TEST(Pc2, GoesOnWhereARunStopped) {
  const TemporaryFolder folder;
  const auto whole = folder.path() / "whole.pc2", parts = folder.path() / "parts.pc2";
  Pc2Writer writer(whole, 2);
  for (int i = 0; i < 4; ++i) writer.append(frame(i));
  {
    Pc2Writer first(parts, 2);
    for (int i = 0; i < 3; ++i) first.append(frame(i));
  }
  Pc2Writer second = Pc2Writer::resume(parts, 2, 2);  // the third frame is computed again
  EXPECT_EQ(second.frame_count(), 2);
  for (int i = 2; i < 4; ++i) second.append(frame(i));
  EXPECT_EQ(content_of(parts), content_of(whole));
}

TEST(Pc2, RefusesToGoOnWithAnotherCache) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.pc2";
  Pc2Writer(path, 2).append(frame(0));
  EXPECT_THAT(input_error_of([&] { Pc2Writer::resume(path, 3, 1); }).problem(),
              HasSubstr("1 frames of 2 points"));
  EXPECT_THROW(Pc2Writer::resume(path, 2, 2), InputError);
  EXPECT_THROW(Pc2Writer::resume(folder.path() / "none.pc2", 2, 0), InputError);
}

TEST(Pc2, RefusesABadFile) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.pc2";
  Pc2Writer(path, 2).append(frame(0));
  const std::string good = content_of(path);
  const auto problem_of = [&](std::string bytes) {
    return input_error_of([&] { read_pc2(folder.write("bad.pc2", bytes)); }).problem();
  };
  EXPECT_THAT(problem_of(good.substr(0, 20)), HasSubstr("no PC2 file"));
  EXPECT_THAT(problem_of(good.substr(0, good.size() - 1)), HasSubstr("too small"));
  EXPECT_THAT(problem_of(std::string(good).replace(12, 1, "\x02")), HasSubstr("version 2"));
  EXPECT_THAT(problem_of(std::string(good).replace(28, 4, "\xff\xff\xff\x7f")),
              HasSubstr("too small"));
  EXPECT_THAT(problem_of(std::string(good).replace(16, 4, "\xff\xff\xff\xff")),
              HasSubstr("-1 points"));
}

TEST(Pc2, RefusesAFrameOfOtherPointsAndAPlaceThatIsNotThere) {
  const TemporaryFolder folder;
  Pc2Writer writer(folder.path() / "a.pc2", 3);
  EXPECT_THROW(writer.append(frame(0)), AssertionError);
  EXPECT_THROW(Pc2Writer(folder.path() / "none" / "a.pc2", 3), InputError);
}

}  // namespace
}  // namespace pliant
