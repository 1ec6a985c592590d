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
  Pcd,         ///< points of the Point Cloud Library
  Ptx,         ///< points of a terrestrial scanner
  TextPoints,  ///< lines of x y z
  DepthPng,    ///< a picture; of 16 bits it may be depth
  OtherMesh,   ///< a format that assimp reads
  ScanPoses,   ///< Stanford .conf
  Profile,     ///< JSON
  Session,     ///< SQLite
};

/// Extension in lower case, without the dot.
[[nodiscard]] std::string extensionOf(const std::string& path);

/// Whether a file begins with numbers as text, whatever its extension says. @throws IoError when it cannot be read
[[nodiscard]] bool beginsWithNumbers(const std::string& path);

/// @throws IoError when the file is missing, a folder, empty or cannot be read
/// @throws InvalidInput naming the file for a git-lfs pointer, for kinds that are known but not supported (E57,
/// LAS) and for anything else: an extension that says mesh must not contradict the content
[[nodiscard]] FileKind detectFileKind(const std::string& path);

}  // namespace vantage
