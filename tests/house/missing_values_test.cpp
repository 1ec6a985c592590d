#include "house/missing_values.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

using Found = std::vector<std::string>;

TEST(MissingValues, TheTreeHasNoneThatBeginAtMinusOne) {
  std::string report;
  for (const std::string& place : missingValues(VANTAGE_SOURCE_DIR)) report += place + "\n";
  EXPECT_TRUE(report.empty()) << report;
}

TEST(MissingValues, AreFoundInHeadersHoweverTheyAreWritten) {
  const MadeUpTree tree({{"core/io/a.h", "struct A {\n  int position = -1;  ///< none\n  std::int64_t scan{-1};\n};\n"},
                         {"app/b.h", "  int shown_ = - 1;\n"}});
  EXPECT_EQ(missingValues(tree.root()), (Found{"app/b.h:1: shown_", "core/io/a.h:2: position", "core/io/a.h:3: scan"}));
}

TEST(MissingValues, OtherNumbersAndSourcesAreNone) {
  const MadeUpTree tree({{"core/io/a.h",
                          "// was: int x = -1;\n  double low = -1.0;\n  int far = -10;\n  int one = 1;\n"
                          "  int last() { return -1; }\n  if (x == -1) stop();\n"},
                         {"core/io/a.cpp", "  int at = -1;\n"}});
  EXPECT_EQ(missingValues(tree.root()), Found{});
}

TEST(MissingValues, DescriptorsOfFilesAreTheOperatingSystemsOwn) {
  const MadeUpTree tree({{"core/base/atomic_file.h", "  int descriptor_ = -1;\n  int other_ = -1;\n"},
                         {"core/io/other.h", "  int descriptor_ = -1;\n"}});
  EXPECT_EQ(missingValues(tree.root()), (Found{"core/base/atomic_file.h:2: other_", "core/io/other.h:1: descriptor_"}));
}

}  // namespace
}  // namespace vantage::testing
