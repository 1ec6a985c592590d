#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace vantage {

/// What is written to a file that somebody named.
enum class OutputKind : std::uint8_t { Mesh, Report, Picture, Json };

/// Whether a file of this kind may be written at a path: where nothing is, where the file is empty, and in the place of
/// a regular file of the same kind that is no input. What cannot be made again stays: sessions, range images, scanner
/// profiles.
/// @param inputs files that are being read; those that do not exist are passed over
/// @throws InvalidInput that names the path and what is there
void checkOutput(const std::string& path, OutputKind kind, std::span<const std::string> inputs = {});

}  // namespace vantage
