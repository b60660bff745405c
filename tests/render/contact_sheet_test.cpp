#include "pliant/render/contact_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using ::testing::ElementsAre;

TEST(SheetLayout, HasRoomForAllAndNoEmptyRow) {
  for (int count = 1; count <= 400; ++count) {
    const SheetLayout layout = sheet_layout(count);
    EXPECT_GE(layout.columns * layout.rows, count) << count;
    EXPECT_LT(layout.columns * (layout.rows - 1), count) << count;
    EXPECT_GE(layout.columns, layout.rows) << count;
  }
}

TEST(ContactSheet, HasThePicturesRowByRowAndAFreeMargin) {
  std::vector<Image> pictures;
  for (std::uint8_t i = 0; i < 5; ++i) pictures.emplace_back(10, 6, Pixel{i, 0, 0});
  const Image sheet = contact_sheet(pictures, sheet_layout(5), 7);
  const SheetLayout layout = sheet_layout(5);
  ASSERT_EQ(sheet.width(), 10 * layout.columns + 7);
  ASSERT_EQ(sheet.height(), 6 * layout.rows);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(sheet.at(10 * (i % layout.columns) + 9, 6 * (i / layout.columns) + 5)[0], i);
  }
  EXPECT_EQ(sheet.at(sheet.width() - 1, 0), (Pixel{255, 255, 255}));
}

TEST(EvenlyInTime, TakesFirstAndLastAndEvenTimesBetween) {
  EXPECT_THAT(evenly_in_time({0, 1, 2, 3, 4, 5, 6}, 4), ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(evenly_in_time({0, 0.1, 0.2, 0.3, 10, 20}, 3), ElementsAre(0, 4, 5));
}

TEST(EvenlyInTime, TakesNoFrameTwice) {
  EXPECT_THAT(evenly_in_time({0, 9.7, 9.8, 9.9, 10}, 4), ElementsAre(0, 1, 2, 4));
  EXPECT_THAT(evenly_in_time({0, 0.1, 0.2, 0.3, 10}, 4), ElementsAre(0, 2, 3, 4));
}

TEST(EvenlyInTime, TakesAllWhereThereAreFewer) {
  EXPECT_THAT(evenly_in_time({0, 1, 5}, 7), ElementsAre(0, 1, 2));
  EXPECT_THAT(evenly_in_time({3}, 7), ElementsAre(0));
}

TEST(EvenlyInTime, TakesTheLastForASinglePicture) {
  EXPECT_THAT(evenly_in_time({0, 1, 2}, 1), ElementsAre(2));
}

}  // namespace
}  // namespace pliant
