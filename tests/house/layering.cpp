#include "house/layering.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "house/source_files.h"

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

// The rooms in the order in which data walks through them.
constexpr std::array<std::string_view, 15> kRooms{
    "base",        "geometry",   "scanner",     "registration",     "calibration",
    "integration", "composites", "void_space",  "positional_space", "forecast",
    "planning",    "io",         "acquisition", "session",          "report"};

// A header of a heavy dependency, and the only sources of core that may include it.
struct Door {
  const char* header;
  const char* sources;
};
constexpr std::array<Door, 7> kDoors{{{"embree[0-9]*/.*", "geometry/ray_caster\\.cpp"},
                                      {"libqhull_r/.*", "geometry/convex_hull\\.cpp"},
                                      {"OpenMesh/.*", "geometry/decimation\\.cpp"},
                                      {"assimp/.*", "io/assimp_import\\.cpp"},
                                      {"sqlite3\\.h", "session/database\\.cpp"},
                                      {"zstd\\.h", "session/session_blobs\\.cpp"},
                                      {"CLI/.*", ""}}};

const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
const std::regex kWindowHeader("Q[A-Za-z]*|Qt[A-Za-z]*/.*|vtk.*");
const std::regex kPrintingHeader("iostream|print|syncstream");
const std::regex kPrintingCall(
    "std::(cout|cerr|clog)\\b|(^|[^a-zA-Z0-9_])(printf|fprintf|vprintf|puts|putchar|perror)\\s*\\(");

std::optional<std::size_t> roomOf(std::string_view path) {
  const auto room = std::find(kRooms.begin(), kRooms.end(), path.substr(0, path.find('/')));
  if (room == kRooms.end() || path.find('/') == std::string_view::npos) return std::nullopt;
  return static_cast<std::size_t>(room - kRooms.begin());
}

// Names of the rooms and folders of a layer, by which its headers are included.
std::set<std::string> foldersOf(const fs::path& layer) {
  std::set<std::string> folders;
  if (!fs::is_directory(layer)) return folders;
  for (const auto& entry : fs::directory_iterator(layer))
    if (entry.is_directory()) folders.insert(entry.path().filename().string());
  return folders;
}

struct Tree {
  std::set<std::string> widgets;
  std::set<std::string> app;

  [[nodiscard]] bool isWidgets(const std::string& header) const { return belongs(header, "widgets", widgets); }
  [[nodiscard]] bool isApp(const std::string& header) const { return belongs(header, "app", app); }

 private:
  // A header is named from the root ("widgets/x/y.h") or from inside of its layer ("x/y.h").
  [[nodiscard]] static bool belongs(const std::string& header, const std::string& layer,
                                    const std::set<std::string>& folders) {
    const std::string first = header.substr(0, header.find('/'));
    return first != header && (first == layer || folders.contains(first));
  }
};

// Why a file of core, named from core/, must not include a header; nothing when it may.
std::optional<std::string> objectionInCore(const Tree& tree, const std::string& file, const std::string& header) {
  const auto own = roomOf(file);
  const auto other = roomOf(header);
  if (!own) return "is in no known room of core";
  if (other && *other > *own)
    return "room " + std::string(kRooms[*own]) + " stands before " + std::string(kRooms[*other]);
  if (!other && tree.isWidgets(header)) return "core does not know the widgets";
  if (!other && (tree.isApp(header) || header.starts_with("tests/"))) return "core does not know who calls it";
  if (std::regex_match(header, kWindowHeader)) return "core has no window library";
  if (std::regex_match(header, kPrintingHeader)) return "core does not print";
  if (header == "random") return "core draws its numbers from base/random.h";
  for (const Door& door : kDoors)
    if (std::regex_match(header, std::regex(door.header)) && !std::regex_match(file, std::regex(door.sources)))
      return "this dependency has another door";
  return std::nullopt;
}

std::optional<std::string> objection(const Tree& tree, const std::string& layer, const std::string& file,
                                     const std::string& header) {
  if (layer == "core") return objectionInCore(tree, file, header);
  if (header.starts_with("tests/") || header.starts_with("gtest/")) return "only tests include tests";
  if (layer == "widgets" && !roomOf(header) && !tree.widgets.contains(header.substr(0, header.find('/'))) &&
      tree.isApp(header))
    return "widgets do not know the app";
  return std::nullopt;
}

void checkFile(const Tree& tree, const SourceFile& source, std::vector<std::string>& violations) {
  const std::string layer = source.layer();
  const std::string file = source.name.substr(layer.size() + 1);
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    const std::string& line = source.lines[i];
    auto report = [&](const std::string& why) {
      violations.push_back(source.name + ":" + std::to_string(i + 1) + ": " + why + ": " + line);
    };
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) {
      if (const auto why = objection(tree, layer, file, match[1].str())) report(*why);
      continue;
    }
    if (layer == "core" && std::regex_search(withoutComment(line), kPrintingCall)) report("core does not print");
  }
}

}  // namespace

std::vector<std::string> layeringViolations(const fs::path& root) {
  const Tree tree{foldersOf(root / "widgets"), foldersOf(root / "app")};
  std::vector<std::string> violations;
  for (const SourceFile& file : sourceFiles(root)) checkFile(tree, file, violations);
  return violations;
}

}  // namespace vantage::testing
