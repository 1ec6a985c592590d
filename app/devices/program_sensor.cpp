#include "devices/program_sensor.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "devices/folder_watch.h"
#include "devices/program_run.h"
#include "io/file_kind.h"
#include "io/profile_scan.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLittleRoom = 64U << 20;  // [bytes]

std::string roomText(const std::string& folder) {
  std::error_code failed;
  const fs::space_info room = fs::space(folder, failed);
  if (failed || room.available > kLittleRoom) return {};
  return " (the disk of " + folder + " has only " + std::to_string(room.available >> 20) + " MB left)";
}

// What follows {file} in the arguments, if it is an extension.
std::string extensionIn(const std::vector<std::string>& run) {
  for (const std::string& argument : run) {
    const std::size_t at = argument.find("{file}.");
    if (at == std::string::npos) continue;
    const std::size_t begin = at + std::string("{file}").size();
    std::size_t end = begin + 1;
    while (end < argument.size() && std::isalnum(static_cast<unsigned char>(argument[end])) != 0) ++end;
    if (end > begin + 1) return argument.substr(begin, end - begin);
  }
  return {};
}

}  // namespace

ProgramSensor::ProgramSensor(ProgramDevice program, std::shared_ptr<const ScannerProfile> profile,
                             ScanReadingOptions reading)
    : program_(std::move(program)), profile_(std::move(profile)), reading_(reading) {
  if (program_.run.empty()) throw InvalidInput("a scanner needs a program: the list of its arguments is empty");
  if (!names(program_.run, "file"))
    throw InvalidInput("the arguments of " + program_.run.front() +
                       " have no {file}: that is where the name of the range file to write is filled in");
  static_cast<void>(filledIn(program_.run, {{"file", ""}, {"position", ""}, {"angle", ""}, {"tilt", ""}}));
}

ProgramSensor::~ProgramSensor() {
  close();
}

void ProgramSensor::open(const Progress& progress) {
  progress.checkpoint(0.0);
  if (!folder_.empty()) return;
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  std::string folder = (temporary / "vantage-scan-XXXXXX").string();
  if (failed || ::mkdtemp(folder.data()) == nullptr)
    throw DeviceError(identity() + ": no folder can be made for its files in " + temporary.string() + ": " +
                      std::strerror(errno) + "; make room there, or set TMPDIR to another folder");
  folder_ = folder;
}

void ProgramSensor::close() noexcept {
  if (folder_.empty()) return;
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  folder_.clear();
}

std::optional<std::string> ProgramSensor::notReady() const {
  if (folder_.empty()) return "it is not open";
  return std::nullopt;
}

void ProgramSensor::emptyFolder() const noexcept {
  try {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry.path(), ignored);
  } catch (const std::exception&) {
    // What stays does no harm: it is removed with the folder.
  }
}

RangeImage ProgramSensor::capture(const Progress& progress) {
  if (folder_.empty()) throw DeviceError(identity() + ": it is not open");
  std::error_code failed;
  fs::create_directories(folder_, failed);
  emptyFolder();
  const std::string extension = extensionIn(program_.run);
  const std::string name = (fs::path(folder_) / "scan").string() + (extension.empty() ? ".ply" : "");
  TableTurn turn;
  if (pose_) turn = turnBetween(profile_->workspace, 0, pose_->position);
  const std::vector<std::string> run =
      filledIn(program_.run, {{"file", name},
                              {"position", std::to_string(pose_ ? pose_->position : 0)},
                              {"angle", argumentText(degrees(turn.angle))},
                              {"tilt", argumentText(degrees(turn.tilt))}});
  const ProgramEnd end =
      runProgram(run, program_.timeout, "scanning with " + program_.run.front(), progress.part(0.0, 0.8));
  output_ = end.output + end.errors;
  if (end.exitCode != 0)
    throw DeviceError(identity() + ": it ended with exit code " + std::to_string(end.exitCode) + saidLast(end) +
                      roomText(folder_));
  const std::string file = written(name + extension, saidLast(end));
  try {
    std::optional<Pose> T_table_scanner;
    if (pose_) T_table_scanner = pose_->T_table_scanner;
    RangeImage image =
        readScan(file, *profile_, reading_, progress.part(0.8, 1.0, "reading the scan"), T_table_scanner);
    emptyFolder();
    return image;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    throw DeviceError(identity() + ": its file cannot be used: " + e.what() + saidLast(end) + roomText(folder_));
  }
}

// A program may have chosen an extension of its own.
std::string ProgramSensor::written(const std::string& file, const std::string& said) const {
  std::string found = file;
  if (!fs::exists(file)) {
    std::vector<std::string> others;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file() && !FolderWatch::isIgnored(entry.path().filename().string()))
        others.push_back(entry.path().string());
    if (others.size() != 1)
      throw DeviceError(identity() + ": it ended well but wrote no file " + file +
                        (others.empty() ? "" : " and " + std::to_string(others.size()) + " others") + said +
                        roomText(folder_));
    found = others.front();
  }
  if (fs::file_size(found) == 0) throw DeviceError(identity() + ": it wrote an empty file" + said + roomText(folder_));
  // Points as text under a name of ours, which does not say so.
  if (extensionOf(found) == "ply" && beginsWithNumbers(found)) {
    const std::string text = found + ".xyz";
    fs::rename(found, text);
    return text;
  }
  return found;
}

}  // namespace vantage
