#include "report/html_parts.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(HtmlParts, AreTablesFiguresAndPicturesThatNeedNoOtherFile) {
  EXPECT_EQ(decimalText(2.345, 1), "2.3");
  EXPECT_EQ(htmlRow({"a", "b"}), "<tr><td>a</td><td>b</td></tr>\n");
  EXPECT_EQ(htmlRow({"a"}, "th"), "<tr><th>a</th></tr>\n");
  EXPECT_EQ(htmlCell("1"), "<td>1</td>");
  EXPECT_NE(pictureHtml({"a<b", "ABC"}).find("data:image/png;base64,QUJD\""), std::string::npos);
  EXPECT_NE(pictureHtml({"a<b", "AB"}).find("base64,QUI=\""), std::string::npos);
  EXPECT_NE(pictureHtml({"a<b", ""}).find("a&lt;b"), std::string::npos);
  EXPECT_EQ(picturesHtml({}), "");
}

}  // namespace
}  // namespace vantage
