#include "house/untested_headers.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

using Found = std::vector<std::string>;

TEST(UntestedHeaders, TheTreeHasNone) {
  ASSERT_TRUE(std::filesystem::exists(std::filesystem::path(VANTAGE_SOURCE_DIR) / "core/session/session.h"));
  std::string report;
  for (const std::string& header : untestedHeaders(VANTAGE_SOURCE_DIR)) report += header + "\n";
  EXPECT_TRUE(report.empty()) << report;
}

TEST(UntestedHeaders, AreThoseThatNoTestOfTheirRoomIncludes) {
  const MadeUpTree tree({{"core/planning/plan.h", ""},
                         {"core/planning/sight.h", ""},
                         {"core/session/loss.h", ""},
                         {"core/session/lock.h", ""},
                         {"core/session/lock.cpp", ""},
                         {"tests/core/planning/plan_test.cpp", "#include \"planning/plan.h\"\n"},
                         {"tests/core/session/all_test.cpp", "\n#include \"session/loss.h\"\n// session/lock.h\n"}});
  EXPECT_EQ(untestedHeaders(tree.root()), (Found{"core/planning/sight.h", "core/session/lock.h"}));
}

TEST(UntestedHeaders, AreNotTestedByOtherRoomsNorByWhatTestsAreMadeOf) {
  const MadeUpTree tree({{"core/acquisition/stand.h", ""},
                         {"tests/core/session/stand_test.cpp", "#include \"acquisition/stand.h\"\n"},
                         {"tests/core/acquisition/scenes.cpp", "#include \"acquisition/stand.h\"\n"}});
  EXPECT_EQ(untestedHeaders(tree.root()), Found{"core/acquisition/stand.h"});
}

TEST(UntestedHeaders, OfOtherRoomsDoNotCount) {
  const MadeUpTree tree({{"core/base/errors.h", ""}, {"app/wording.h", ""}});
  EXPECT_EQ(untestedHeaders(tree.root()), Found{});
}

}  // namespace
}  // namespace vantage::testing
