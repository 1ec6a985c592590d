#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace vantage {

/// A folder of what the programs bring along: "turntables", "scanners", "objects"; empty: the folder that has
/// them. Looked for in the folder that the environment variable VANTAGE_RESOURCES names; without it where an
/// installation has it, seen from the program, so that the whole may be moved; else in bin/resources of the build
/// folder. The folder need not exist.
[[nodiscard]] std::string resourceFolder(const std::string& name);

/// The same for a program at another place.
/// @param named what VANTAGE_RESOURCES says; empty: nothing
[[nodiscard]] std::string resourceFolder(const std::string& name, const std::filesystem::path& program,
                                         const std::string& named);

/// A program that belongs to this one and that nobody starts by hand: beside it in the build folder, in the folder of
/// such programs when it is installed. Nothing where it is not installed.
[[nodiscard]] std::optional<std::filesystem::path> helperProgram(const std::string& name);

/// The same for a program at another place.
[[nodiscard]] std::optional<std::filesystem::path> helperProgram(const std::string& name,
                                                                 const std::filesystem::path& program);

/// The file that this program was started from; empty where the system does not say.
[[nodiscard]] std::filesystem::path programFile();

}  // namespace vantage
