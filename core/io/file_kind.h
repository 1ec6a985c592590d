#pragma once

#include <string>
#include <string_view>

namespace vantage {

/// What a file is, by its first bytes and its extension; nothing is checked beyond that.
enum class FileKind {
  Ply,  ///< mesh, model, points or range image: its header tells
  Stl,
  Obj,
  Off,
  ThreeMf,
  Pcd,        ///< points of the Point Cloud Library
  Ptx,        ///< points of a terrestrial scanner
  OtherMesh,  ///< a format that assimp reads
  ScanPoses,  ///< Stanford .conf
  Profile,    ///< JSON
  Session,    ///< SQLite
};

/// Extension in lower case, without the dot.
[[nodiscard]] std::string extensionOf(const std::string& path);

/// @throws IoError when the file is missing, a folder, empty or cannot be read
/// @throws InvalidInput naming the file for a git-lfs pointer, for kinds that are known but not supported (E57,
/// LAS, points as plain text) and for anything else: an extension that says mesh must not contradict the content
[[nodiscard]] FileKind detectFileKind(const std::string& path);

}  // namespace vantage
