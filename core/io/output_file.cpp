#include "io/output_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "io/file_kind.h"
#include "io/ply_header.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeadBytes = 512;

std::string headOf(const std::string& path) {
  std::string head(kHeadBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

// The kind of mesh file, profile or session that it is; nothing for what is none.
std::optional<FileKind> knownKind(const std::string& path) {
  try {
    return detectFileKind(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool isRange(const std::string& path) {
  const PlyHeader header = readPlyHeader(path);
  return header.find("range_grid") != nullptr || header.find("face") == nullptr;
}

bool isMesh(const std::string& path) {
  const auto kind = knownKind(path);
  if (kind == FileKind::Ply) return !isRange(path);
  return kind == FileKind::Stl || kind == FileKind::Obj || kind == FileKind::ThreeMf;  // what models are written as
}

bool isPage(const std::string& path) {
  std::string head = headOf(path);
  std::transform(head.begin(), head.end(), head.begin(), [](unsigned char c) { return std::tolower(c); });
  return head.find("<!doctype html") != std::string::npos || head.find("<html") != std::string::npos;
}

// A scanner profile is JSON that somebody made by hand.
bool isJson(const std::string& path) {
  if (knownKind(path) != FileKind::Profile) return false;
  const FileBytes bytes(path);
  const auto json = nlohmann::json::parse(bytes.text(), nullptr, false);
  return json.is_object() && !json.contains("scanner");
}

bool isOf(const std::string& path, OutputKind kind) {
  switch (kind) {
    case OutputKind::Mesh:
      return isMesh(path);
    case OutputKind::Report:
      return isPage(path);
    case OutputKind::Picture:
      return headOf(path).starts_with("\x89PNG");
    case OutputKind::Json:
      return isJson(path);
  }
  return false;
}

std::string_view titleOf(OutputKind kind) {
  constexpr std::array<std::string_view, 4> kTitles{"mesh", "HTML page", "PNG picture", "JSON file of Vantage"};
  return kTitles[static_cast<std::size_t>(kind)];
}

}  // namespace

void checkOutput(const std::string& path, OutputKind kind, std::span<const std::string> inputs) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return;
  if (!fs::is_regular_file(status)) throw InvalidInput(path + ": is no regular file, nothing is written there");
  for (const std::string& input : inputs)
    if (fs::equivalent(path, input, error))
      throw InvalidInput(path + ": is read by this command and stays as it is, choose another name to write to");
  if (fs::file_size(path, error) == 0 && !error) return;
  bool same = false;
  try {
    same = isOf(path, kind);
  } catch (const Error&) {
    same = false;  // what cannot be read as that kind is of another
  }
  if (!same)
    throw InvalidInput(path + ": is there already and is no " + std::string(titleOf(kind)) +
                       ", so it is not replaced: choose another name, or move it away");
}

}  // namespace vantage
