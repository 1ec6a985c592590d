#include "scanner/number_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

std::string messageFor(const std::string& text, std::size_t maxRows = 10, std::size_t maxColumns = 4) {
  try {
    static_cast<void>(parseNumberTable(text, "table.csv", maxRows, maxColumns));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(NumberTable, ReadsRowsWithAnyDividerAndLineEnd) {
  const NumberTable table = parseNumberTable("1,2,3\n-4; 5e1 ;+.6\r\n\t7 8 9", "table.csv", 10, 10);
  EXPECT_EQ(table.columns, 3U);
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.values, (std::vector<double>{1, 2, 3, -4, 50, 0.6, 7, 8, 9}));
  EXPECT_EQ(table.row(1)[1], 50.0);
}

TEST(NumberTable, SkipsCommentsBlankLinesAndOneHeader) {
  const NumberTable table = parseNumberTable("# about\n\nox,oy\n1,2\n  # more\n , \n3,4\n", "table.csv", 10, 10);
  EXPECT_EQ(table.values, (std::vector<double>{1, 2, 3, 4}));
}

TEST(NumberTable, NothingIsAnEmptyTable) {
  EXPECT_EQ(parseNumberTable("", "table.csv", 10, 10).rows(), 0U);
  EXPECT_EQ(parseNumberTable("x,y,z\n", "table.csv", 10, 10).rows(), 0U);
}

TEST(NumberTable, ErrorsNameFileLineAndField) {
  EXPECT_EQ(messageFor("1,2\n3,four"), "table.csv: line 2 has \"four\", expected a finite number");
  EXPECT_EQ(messageFor("1,2\n3,nan"), "table.csv: line 2 has \"nan\", expected a finite number");
  EXPECT_EQ(messageFor("1,2\n3,1e999"), "table.csv: line 2 has \"1e999\", expected a finite number");
  EXPECT_EQ(messageFor("1,2\n3,0x10"), "table.csv: line 2 has \"0x10\", expected a finite number");
  EXPECT_EQ(messageFor("1\n\x1b[2J"), "table.csv: line 2 has \"\\u001b[2J\", expected a finite number");
  EXPECT_EQ(messageFor("1,2\n3"), "table.csv: line 2 has 1 numbers, expected 2 as in the lines before");
  EXPECT_EQ(messageFor("1,2,3,4,5"), "table.csv: line 1 has more than 4 numbers, expected no more");
  EXPECT_EQ(messageFor("1\n2\n3\n", 2), "table.csv: line 3 has row 3, expected no more than 2");
}

TEST(NumberTable, WhatIsInAFileOutsideOfTheProfilesFolderIsNotQuoted) {
  for (const char* file : {"/etc/passwd", "../passwd", "a/../../passwd"}) {
    try {
      static_cast<void>(parseNumberTable("1,2\n3,secret", file, 10, 4));
      FAIL();
    } catch (const InvalidInput& e) {
      EXPECT_EQ(e.what(), std::string(file) + ": line 2 has a field that is none, expected a finite number");
    }
  }
}

TEST(NumberTable, ASecondHeaderIsAnError) {
  EXPECT_EQ(messageFor("a,b\nc,d\n"), "table.csv: line 2 has \"c\", expected a finite number");
}

}  // namespace
}  // namespace vantage
