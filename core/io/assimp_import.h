#pragma once

#include <string>
#include <vector>

#include "io/polygon_soup.h"

namespace vantage {

/// Reads a mesh in any of assimp's formats, all objects of its scene in place. assimp runs in a child process with
/// limits of time and memory, because some of its readers crash or do not end on damaged files: 1 GiB or 24 times the
/// file's size, 3 s of CPU time and 1 s per MiB, three times that by the clock.
/// @throws InvalidInput naming the file and what assimp said, or that it crashed, took too long or too much memory
/// @throws IoError when no child process can be made
/// @throws Cancelled
[[nodiscard]] PolygonSoup importWithAssimp(const std::string& path, const Progress& progress = {});

/// Extensions of the files that assimp reads, lower case without the dot, in alphabetical order.
[[nodiscard]] std::vector<std::string> assimpExtensions();

}  // namespace vantage
