#include "house/documents.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

using Violations = std::vector<std::string>;

std::vector<std::string> pathsIn(std::string_view markdown) {
  std::vector<std::string> paths;
  for (const NamedFile& file : filesNamedIn(markdown)) paths.push_back(file.path);
  return paths;
}

TEST(Documents, OfTheTreeNameFilesThatAreThere) {
  const std::filesystem::path root = VANTAGE_SOURCE_DIR;
  ASSERT_TRUE(std::filesystem::exists(root / "README.md"));
  EXPECT_EQ(documentViolations(root), Violations{});
}

TEST(Documents, NameFilesInBackquotesAndLinks) {
  EXPECT_EQ(pathsIn("`core/io/a.h` and `app/` beside [this](b/c.md#part) ![that](d.png)"),
            (std::vector<std::string>{"b/c.md", "d.png", "core/io/a.h", "app/"}));
}

TEST(Documents, NameNoFilesInCodeWordsAddressesAndPlacesOfTheirOwn) {
  EXPECT_EQ(
      pathsIn("```\n`core/io/a.h`\n```\n`mug.ply`, `a b/c`, `build/dev/bin`, [x](https://example.org/y), [z](#z)"),
      std::vector<std::string>{});
}

TEST(Documents, FindPathsFromTheRootOrCoreAndLinksFromWhereTheyAre) {
  const MadeUpTree tree({{"README.md", "`core/io/a.h`, `io/a.h`, [a](core/io/a.h)"},
                         {"core/README.md", "\n`io/b.h` [a](io/a.h) [b](../README.md) [c](README.txt)"},
                         {"core/io/a.h", ""}});
  EXPECT_EQ(documentViolations(tree.root()), (Violations{"core/README.md:2: names a file that is not there: README.txt",
                                                         "core/README.md:2: names a file that is not there: io/b.h"}));
}

}  // namespace
}  // namespace vantage::testing
