#include "house/sentences.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> textsIn(std::string_view source) {
  std::vector<std::string> texts;
  for (const Sentence& sentence : sentencesIn(source)) texts.push_back(sentence.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(Sentences, TheResultsOfTheTreeAreCodesAndNumbers) {
  const fs::path root = VANTAGE_SOURCE_DIR;
  ASSERT_TRUE(fs::exists(root / "core/registration/verdict.cpp"));
  std::string report;
  for (const std::string& violation : sentenceViolations(root)) report += violation + "\n";
  EXPECT_TRUE(report.empty()) << report;
}

TEST(Sentences, AreLiteralsWithASpace) {
  EXPECT_EQ(textsIn("x = \"the first view\"; y = \"first_view\"; z = \"\";"), Texts{"the first view"});
  EXPECT_EQ(textsIn("x = R\"(raw words)\" + R\"end(more )\" words)end\" + \"\\\" quoted\";"),
            (Texts{"raw words", "more )\" words", "\\\" quoted"}));
}

TEST(Sentences, AreCountedByLine) {
  const auto found = sentencesIn("int a;\n/* two\nlines */\nauto b = \"a b\";\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].line, 4);
}

TEST(Sentences, OfCommentsDoNotCount) {
  EXPECT_EQ(textsIn("// \"a b\"\n/// \"c d\"\n/* \"e f\" */ x = \"g h\"; // \"i j\""), Texts{"g h"});
}

TEST(Sentences, OfErrorsDoNotCountUpToTheEndOfTheirStatement) {
  EXPECT_EQ(textsIn("if (bad) throw InvalidInput(\"view \" + n +\n  \" is not there\");\nreturn \"a b\";"),
            Texts{"a b"});
  EXPECT_EQ(textsIn("rethrown(\"a b\");"), Texts{"a b"});
}

TEST(Sentences, QuotesOfCharactersAndNumbersOpenNone) {
  EXPECT_EQ(textsIn("a = '\"'; b = 10'000; c = '\\''; d = \"e f\"; g = 1'000'000;"), Texts{"e f"});
}

TEST(Sentences, CountInRoomsThatMakeResultsOnly) {
  const fs::path root = fs::path(::testing::TempDir()) / "sentences_in_rooms";
  fs::remove_all(root);
  for (const char* file : {"core/planning/plan.cpp", "core/acquisition/settings_table.cpp", "core/report/wording.cpp",
                           "app/wording.cpp", "core/registration/notes.txt"}) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << "\nauto x = \"a b\";\n";
  }
  EXPECT_EQ(sentenceViolations(root), Texts{"core/planning/plan.cpp:2: results are codes and numbers: \"a b\""});
  fs::remove_all(root);
  EXPECT_TRUE(sentenceViolations(root).empty());
}

}  // namespace
}  // namespace vantage::testing
