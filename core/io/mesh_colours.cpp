#include "io/mesh_colours.h"

#include <array>
#include <cmath>
#include <optional>

#include "io/file_bytes.h"
#include "io/file_kind.h"
#include "io/ply_colours.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::array<PlySelection, 3> kChannels{{{"vertex", "red"}, {"vertex", "green"}, {"vertex", "blue"}}};
constexpr std::size_t kLinesPerCheckpoint = 65536;

// What stands behind the coordinates of a vertex; nothing where that is no colour.
std::optional<Colour> colourOnLine(TextScanner& text) {
  for (int k = 0; k < 3; ++k) static_cast<void>(text.fieldOnLine());
  Colour colour{};
  for (std::uint8_t& channel : colour) {
    const std::optional<double> share = parseNumber(text.fieldOnLine());
    if (!share || !(*share >= 0.0 && *share <= 1.0)) return std::nullopt;
    channel = static_cast<std::uint8_t>(std::lround(255.0 * *share));
  }
  return colour;
}

std::vector<Colour> readPlyColours(const FileBytes& file, const Progress& progress) {
  const PlyHeader header = parsePlyHeader(file.text(), file.size(), file.path());
  const PlyElement* vertex = header.find("vertex");
  if (vertex == nullptr || vertex->find("red") == nullptr) return {};
  return vertexColours(readPlyDocument(file, kChannels, progress));
}

std::vector<Colour> readObjColours(const FileBytes& file, const Progress& progress) {
  TextScanner text(file.text(), file.path());
  std::vector<Colour> colours;
  std::size_t lines = 0;
  do {
    if (lines++ % kLinesPerCheckpoint == 0) progress.checkpoint(0.0);
    if (text.fieldOnLine() != "v") continue;
    const std::optional<Colour> colour = colourOnLine(text);
    if (!colour) return {};
    colours.push_back(*colour);
  } while (text.nextLine());
  return colours;
}

}  // namespace

std::vector<Colour> readMeshColours(const std::string& path, const Progress& progress) {
  switch (detectFileKind(path)) {
    case FileKind::Ply:
      return readPlyColours(FileBytes(path), progress);
    case FileKind::Obj:
      return readObjColours(FileBytes(path), progress);
    default:
      return {};
  }
}

}  // namespace vantage
