#include "house/include_cycles.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

using Circles = std::vector<std::string>;

std::string including(const std::string& header) {
  return "#pragma once\n#include \"" + header + "\"\n";
}

TEST(IncludeCycles, TheTreeHasNone) {
  EXPECT_EQ(includeCycles(VANTAGE_SOURCE_DIR), Circles{});
}

TEST(IncludeCycles, ACircleIsNamedOnceFromItsFirstHeader) {
  const MadeUpTree tree({{"core/io/c.h", including("io/a.h")},
                         {"core/io/a.h", including("io/b.h")},
                         {"core/io/b.h", including("io/c.h")},
                         {"core/io/d.h", including("io/a.h")}});
  EXPECT_EQ(includeCycles(tree.root()), Circles{"core/io/a.h > core/io/b.h > core/io/c.h > core/io/a.h"});
}

TEST(IncludeCycles, HeadersThatShareOneAreNoCircle) {
  const MadeUpTree tree({{"core/io/a.h", including("io/b.h") + including("io/c.h")},
                         {"core/io/b.h", including("io/c.h")},
                         {"core/io/c.h", including("vector")},
                         {"core/io/c.cpp", including("io/a.h")}});
  EXPECT_EQ(includeCycles(tree.root()), Circles{});
}

TEST(IncludeCycles, WidgetsAndAppCountToo) {
  const MadeUpTree tree({{"widgets/vtk/a.h", including("widgets/vtk/b.h")},
                         {"widgets/vtk/b.h", including("vtk/a.h")},
                         {"app/x.h", including("y.h")},
                         {"app/y.h", including("x.h")}});
  EXPECT_EQ(includeCycles(tree.root()),
            (Circles{"app/x.h > app/y.h > app/x.h", "widgets/vtk/a.h > widgets/vtk/b.h > widgets/vtk/a.h"}));
}

}  // namespace
}  // namespace vantage::testing
