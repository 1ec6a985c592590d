#include "io/file_kind.h"

#include <algorithm>
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

// Files whose content says what they are not.
void refuseKnownOthers(const std::string& path, std::string_view head, const std::string& extension) {
  if (head.starts_with("version https://git-lfs.github.com/"))
    throw InvalidInput(path + ": is a git-lfs pointer, not the file itself: fetch it with 'git lfs pull'");
  if (head.starts_with("ASTM-E57") || extension == "e57")
    throw InvalidInput(path +
                       ": is an E57 point cloud, which is not supported: export a PLY range file or a mesh instead");
  if (extension == "ptx")
    throw InvalidInput(path +
                       ": is a PTX point cloud, which is not supported: export a PLY range file or a mesh instead");
}

}  // namespace

std::string extensionOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : lowerCase(std::string_view(extension).substr(1));
}

FileKind detectFileKind(const std::string& path) {
  const std::string head = readHead(path, kHeadBytes);
  const std::string extension = extensionOf(path);
  refuseKnownOthers(path, head, extension);
  if (looksLikePly(head)) return FileKind::Ply;
  if (head.starts_with(std::string_view("SQLite format 3\0", 16))) return FileKind::Session;
  if (extension == "ply")
    throw InvalidInput(path + ": begins with " + inQuotes(head) + ", a PLY file begins with the line 'ply'");
  if (extension == "stl") return FileKind::Stl;
  if (extension == "obj") return FileKind::Obj;
  if (extension == "off") return FileKind::Off;
  if (extension == "3mf") return FileKind::ThreeMf;
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
