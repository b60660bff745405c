#include "pliant/report/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(EscapeHtml, DisarmsMarkupAndQuotes) {
  EXPECT_EQ(escape_html("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
}

TEST(BulletList, IsNothingWithoutItems) { EXPECT_EQ(bullet_list({}), ""); }

TEST(HtmlTable, EscapesCellsAndAlignsNumbers) {
  HtmlTable table({{"Name"}, {"Force", HtmlTable::Align::number}});
  table.begin_row();
  table.cell("<script>");
  table.cell("1.5");
  EXPECT_THAT(table.html(), HasSubstr("<td>&lt;script&gt;</td><td class=\"number\">1.5</td></tr>"));
  EXPECT_THAT(table.html(), Not(HasSubstr("<script>")));
}

TEST(HtmlTable, RefusesMoreCellsThanColumns) {
  HtmlTable table({{"Only"}});
  table.begin_row();
  table.cell("1");
  EXPECT_THROW(table.cell("2"), std::out_of_range);
}

}  // namespace
}  // namespace pliant::report
