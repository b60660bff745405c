#include "pliant/report/sheet_view.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/io/base64.h"
#include "pliant/report/sheet_picture.h"

#include "report/sample_sheets.h"

namespace pliant::report {
namespace {

using testing::hanging_sheet;
using testing::stretched_sheet;
using testing::with_residuals;

/// Coordinates of a view (m), frame after frame.
std::vector<double> coordinates(const nlohmann::json& view, const char* side) {
  const std::string bytes = *bytes_of_base64(view[side].get<std::string>());
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const int steps =
        static_cast<unsigned char>(bytes[i]) + 256 * static_cast<unsigned char>(bytes[i + 1]);
    const double low = view["low"][values.size() % 3].get<double>();
    values.push_back(low + view["step"].get<double>() * steps);
  }
  return values;
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(SheetView, HoldsThePositionsOfAllFramesToAMicron) {
  const SheetSession sheet = with_residuals(hanging_sheet(3), 2e-3, 0);
  const nlohmann::json view = sheet_view(sheet, 40);
  for (const char* side : {"measured", "predicted"}) {
    const Session& session = *side == 'm' ? sheet.measured : sheet.predicted;
    const std::vector<double> found = coordinates(view, side);
    std::size_t i = 0;
    for (const SessionFrame& frame : session.frames) {
      for (const double expected : frame.positions.reshaped()) {
        ASSERT_LT(i, found.size());
        EXPECT_NEAR(found[i++], expected, 2e-6);  // half a step and what rounds its corner
      }
    }
    EXPECT_EQ(i, found.size());
  }
}

TEST(SheetView, BeginsWithTheMostDistortedFrameHoweverFewItShows) {
  Session session = stretched_sheet(100, 5e-3, 100);
  std::swap(session.frames[37], session.frames[99]);
  const nlohmann::json view = sheet_view(with_residuals(session, 1e-3, 0), 6);
  EXPECT_EQ(view["frames"].size(), 7u);
  EXPECT_EQ(view["frames"][view["first"].get<std::size_t>()]["number"], 37);
  EXPECT_EQ(view["frames"].back()["number"], 99);
}

TEST(SheetView, TellsTheResidualOfEachFrame) {
  const nlohmann::json view = sheet_view(with_residuals(hanging_sheet(2), 2e-3, 0), 40);
  EXPECT_EQ(view["frames"][0]["text"], "RMS of free nodes 2 mm, largest 2 mm");
  EXPECT_NEAR(view["largest_mm"].get<double>(), 2, 1e-9);
}

TEST(SheetPicture, HasEveryTriangleTwiceAndAnArrowForEachForce) {
  const SheetSession sheet = with_residuals(stretched_sheet(3, 5e-3, 100), 1e-3, 0.1);
  const auto triangles = static_cast<std::size_t>(sheet.measured.rest.triangle_count());
  EXPECT_EQ(count(sheet_picture(sheet, 2, 1e-3), "z"), 2 * triangles + 4);
}

TEST(SheetPicture, DrawsTheResidualOfEachFreeNode) {
  const SheetSession sheet = with_residuals(hanging_sheet(3), 2e-3, 0);
  const std::string picture = residual_picture(sheet, 2);
  const std::size_t begin = picture.find("sheet-residual");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(count(std::string_view(picture).substr(begin), "M"),
            free_nodes(sheet.measured, 2).size());
}

}  // namespace
}  // namespace pliant::report
