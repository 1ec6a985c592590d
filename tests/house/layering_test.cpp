#include "house/layering.h"

#include "house/made_up_tree.h"

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

using Violations = std::vector<std::string>;

Violations violationsOf(const std::string& file, const std::string& text) {
  const MadeUpTree tree({{"widgets/vtk/surface.h", ""}, {"app/cli/command.h", ""}, {file, text}});
  return layeringViolations(tree.root());
}

std::string includeOf(const std::string& header) {
  return "#pragma once\n#include <vector>\n#include \"" + header + "\"\n";
}

TEST(Layering, TheTreeKeepsTheRulesOfTheHouse) {
  const fs::path root = VANTAGE_SOURCE_DIR;
  ASSERT_TRUE(fs::exists(root / "core/base/errors.h"));
  std::string report;
  for (const std::string& violation : layeringViolations(root)) report += violation + "\n";
  EXPECT_TRUE(report.empty()) << report;
}

TEST(Layering, AGoodTreeHasNoViolations) {
  const MadeUpTree tree(
      {{"core/geometry/mesh.h", "#include <array>\n#include \"base/errors.h\"\n"},
       {"core/geometry/ray_caster.cpp", "#include <embree3/rtcore.h>\n"},
       {"core/io/assimp_import.cpp", "#include <assimp/scene.h>\n#include \"planning/planner.h\"\n"},
       {"widgets/vtk/surface.h", "#include <QWidget>\n#include <vtkActor.h>\n#include \"geometry/mesh.h\"\n"},
       {"app/main.cpp", "#include <iostream>\n#include \"widgets/vtk/surface.h\"\n#include \"cli/command.h\"\n"},
       {"app/cli/command.h", "int main() { std::cout << 1; }\n"}});
  EXPECT_EQ(layeringViolations(tree.root()), Violations{});
}

TEST(Layering, AnEmptyTreeHasNothingToCheck) {
  EXPECT_TRUE(layeringViolations(MadeUpTree({}).root()).empty());
}

TEST(Layering, ViolationsNameFileLineAndReason) {
  EXPECT_EQ(violationsOf("core/geometry/mesh.h", includeOf("scanner/profile.h")),
            Violations{"core/geometry/mesh.h:3: room geometry stands before scanner: #include \"scanner/profile.h\""});
}

TEST(Layering, ARoomMustNotIncludeALaterOne) {
  const std::vector<std::string> rooms{"base",        "geometry",   "scanner",     "registration",
                                       "integration", "composites", "void_space",  "positional_space",
                                       "planning",    "io",         "acquisition", "session",
                                       "report"};
  for (std::size_t own = 0; own < rooms.size(); ++own) {
    for (std::size_t other = 0; other < rooms.size(); ++other) {
      const Violations found = violationsOf("core/" + rooms[own] + "/x.cpp", includeOf(rooms[other] + "/y.h"));
      EXPECT_EQ(found.size(), other > own ? 1U : 0U) << rooms[own] << " includes " << rooms[other];
    }
  }
}

TEST(Layering, CoreKnowsNeitherWidgetsNorApp) {
  for (const std::string header :
       {"widgets/vtk/surface.h", "vtk/surface.h", "app/cli/command.h", "cli/command.h", "tests/x.h"})
    EXPECT_EQ(violationsOf("core/scanner/x.h", includeOf(header)).size(), 1U) << header;
}

TEST(Layering, WidgetsDoNotKnowTheApp) {
  for (const std::string header : {"app/cli/command.h", "cli/command.h"})
    EXPECT_EQ(violationsOf("widgets/vtk/x.h", includeOf(header)).size(), 1U) << header;
}

TEST(Layering, CoreHasNoWindowLibrary) {
  for (const std::string header : {"QString", "QtCore/QString", "vtkActor.h"})
    EXPECT_EQ(violationsOf("core/scanner/x.h", includeOf(header)).size(), 1U) << header;
}

TEST(Layering, CoreDoesNotPrint) {
  for (const std::string code : {"#include <iostream>\n", "  std::cout << 1;\n", "x(); std::cerr << 2;\n",
                                 "printf(\"x\");\n", "  std::fprintf(stderr, \"x\");\n", "puts(\"x\");\n"})
    EXPECT_EQ(violationsOf("core/scanner/x.cpp", code).size(), 1U) << code;
  for (const std::string code :
       {"std::snprintf(text, 5, \"x\");\n", "// printf(\"x\") is not ours\n", "outputs(1);\n", "#include <sstream>\n"})
    EXPECT_TRUE(violationsOf("core/scanner/x.cpp", code).empty()) << code;
}

TEST(Layering, CoreDrawsItsNumbersFromBase) {
  EXPECT_EQ(violationsOf("core/scanner/x.cpp", "#include <random>\n").size(), 1U);
  EXPECT_TRUE(violationsOf("core/scanner/x.cpp", "#include \"base/random.h\"\n").empty());
}

TEST(Layering, AHeavyDependencyHasOneDoor) {
  const std::vector<std::pair<std::string, std::string>> doors{
      {"embree3/rtcore.h", "core/geometry/ray_caster.cpp"},
      {"OpenMesh/Core/Mesh/X.hh", "core/geometry/decimation.cpp"},
      {"assimp/scene.h", "core/io/assimp_import.cpp"},
      {"sqlite3.h", "core/session/database.cpp"}};
  for (const auto& [header, door] : doors) {
    EXPECT_TRUE(violationsOf(door, includeOf(header)).empty()) << door;
    EXPECT_EQ(violationsOf("core/geometry/mesh.cpp", includeOf(header)).size(), 1U) << header;
    EXPECT_EQ(violationsOf("core/session/other.cpp", includeOf(header)).size(), 1U) << header;
  }
  EXPECT_EQ(violationsOf("core/io/x.cpp", includeOf("CLI/CLI.hpp")).size(), 1U);
}

TEST(Layering, AFileOfCoreStandsInARoom) {
  EXPECT_FALSE(violationsOf("core/attic/x.cpp", includeOf("base/errors.h")).empty());
}

}  // namespace
}  // namespace vantage::testing
