#include "io/file_kind.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/errors.h"
#include "io/assimp_import.h"
#include "io/file_bytes.h"
#include "io/ply_header.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kHeadBytes = 4096;

std::string_view firstWord(std::string_view head) {
  const std::size_t begin = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  return head.substr(begin, head.find_first_of(" \t\r\n", begin) - begin);
}

constexpr std::array<std::string_view, 5> kTextPoints{"xyz", "pts", "asc", "csv", "txt"};

// Whether the first of the lines that hold numbers, behind a few of words, begins with one.
bool beginsWithNumbers(std::string_view head, std::size_t wordLines) {
  TextScanner text(head, {});
  do {
    const std::string_view field = text.fieldOnLine();
    if (parseDecimal(field.substr(0, field.find(';')))) return true;
    if (parseNumber(field.substr(0, field.find_first_of(",;")))) return true;
    if (!field.empty() && !field.starts_with('#') && !field.starts_with("//") && wordLines-- == 0) return false;
  } while (text.nextLine());
  return false;
}

// Columns and rows on lines of their own, then three numbers.
bool looksLikePtx(std::string_view head) {
  TextScanner text(head, {});
  for (int i = 0; i < 2; ++i) {
    if (!parseInteger(text.fieldOnLine()) || !text.fieldOnLine().empty() || !text.nextLine()) return false;
  }
  for (int i = 0; i < 3; ++i)
    if (!parseDecimal(text.fieldOnLine())) return false;
  return text.fieldOnLine().empty();
}

constexpr std::size_t kWordLines = 5;  // that a list of points may begin with

bool isText(const std::string& extension, std::string_view head) {
  const bool listed = std::find(kTextPoints.begin(), kTextPoints.end(), extension) != kTextPoints.end();
  return (listed && beginsWithNumbers(head, kWordLines)) || (extension.empty() && beginsWithNumbers(head, 0));
}

// Files whose content says what they are not.
void refuseKnownOthers(const std::string& path, std::string_view head, const std::string& extension) {
  const std::string instead = ", which is not supported: export a range file (PLY, PCD, PTX or XYZ) or a mesh instead";
  if (head.starts_with("version https://git-lfs.github.com/"))
    throw InvalidInput(path + ": is a git-lfs pointer, not the file itself: fetch it with 'git lfs pull'");
  if (head.starts_with("ASTM-E57") || extension == "e57")
    throw InvalidInput(path + ": is an E57 point cloud" + instead);
  if (head.starts_with("LASF") || extension == "las" || extension == "laz")
    throw InvalidInput(path + ": is a LAS point cloud" + instead);
}

}  // namespace

std::string extensionOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : lowerCase(std::string_view(extension).substr(1));
}

bool beginsWithNumbers(const std::string& path) {
  return beginsWithNumbers(readHead(path, kHeadBytes), 0);
}

FileKind detectFileKind(const std::string& path) {
  const std::string head = readHead(path, kHeadBytes);
  const std::string extension = extensionOf(path);
  refuseKnownOthers(path, head, extension);
  if (looksLikePly(head)) return FileKind::Ply;
  if (head.starts_with("# .PCD") || extension == "pcd") return FileKind::Pcd;
  if (head.starts_with(std::string_view("SQLite format 3\0", 16))) return FileKind::Session;
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return FileKind::DepthPng;
  if (extension != "ptx" && isText(extension, head)) return looksLikePtx(head) ? FileKind::Ptx : FileKind::TextPoints;
  if (extension == "ply")
    throw InvalidInput(path + ": begins with " + inQuotes(head) + ", a PLY file begins with the line 'ply'");
  if (extension == "stl") return FileKind::Stl;
  if (extension == "obj") return FileKind::Obj;
  if (extension == "off") return FileKind::Off;
  if (extension == "3mf") return FileKind::ThreeMf;
  if (extension == "ptx") return FileKind::Ptx;
  if (extension == "json") return FileKind::Profile;
  const std::string_view word = firstWord(head);
  if (word == "bmesh" || word == "camera" || extension == "conf") return FileKind::ScanPoses;
  const auto known = assimpExtensions();
  if (std::binary_search(known.begin(), known.end(), extension)) return FileKind::OtherMesh;
  if (word.starts_with('{')) return FileKind::Profile;
  throw InvalidInput(path + ": begins with " + inQuotes(head) +
                     ", which is no mesh, range file, scanner profile or session that is known here");
}

}  // namespace vantage
