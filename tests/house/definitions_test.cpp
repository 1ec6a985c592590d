#include "house/definitions.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

using Found = std::vector<std::string>;

constexpr const char* kHeader = R"(#pragma once
class Box {
  void open();
  struct Lid { void turn(); };
};
[[nodiscard]] std::vector<int> makeBox(const Options& options = {},
                                       const Progress& progress = {});
)";

TEST(Definitions, TheTreeHasThemBesideTheirDeclarations) {
  std::string report;
  for (const std::string& place : strayDefinitions(VANTAGE_SOURCE_DIR)) report += place + "\n";
  EXPECT_TRUE(report.empty()) << report;
}

TEST(Definitions, BelongIntoTheSourceOfTheSameName) {
  const std::string source = "void Box::open() {\n}\nvoid Box::Lid::turn() {}\nstd::vector<int> makeBox(\n";
  const MadeUpTree tree({{"core/io/box.h", kHeader},
                         {"core/io/box.cpp", source},
                         {"core/io/box_making.cpp", source},
                         {"core/io/shelf.cpp", source}});
  EXPECT_EQ(strayDefinitions(tree.root()), (Found{"core/io/shelf.cpp:1: Box::open is declared in box.h",
                                                  "core/io/shelf.cpp:3: Box::Lid::turn is declared in box.h",
                                                  "core/io/shelf.cpp:4: makeBox is declared in box.h"}));
}

TEST(Definitions, CallsAndWhatIsLocalAreNone) {
  const MadeUpTree tree({{"core/io/box.h", kHeader},
                         {"core/io/shelf.cpp",
                          "namespace {\n\nint makeBox(int size) {\n}\n\n}  // namespace\n"
                          "// Box::open(\nvoid Shelf::fill() {\n  makeBox({});\n  Box::open();\n}\n"},
                         {"core/base/other.cpp", "int makeBox(int size) {\n"}});
  EXPECT_EQ(strayDefinitions(tree.root()), Found{});
}

TEST(Definitions, OverloadsMayStandBesideAnyOfTheirHeaders) {
  const MadeUpTree tree({{"core/io/a.h", "std::string name(A a);\n"},
                         {"core/io/b.h", "std::string name(B b);\n"},
                         {"core/io/b.cpp", "std::string name(B b) {\n"}});
  EXPECT_EQ(strayDefinitions(tree.root()), Found{});
}

}  // namespace
}  // namespace vantage::testing
