#include "devices/folder_sensor.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "base/content_hash.h"
#include "base/errors.h"
#include "io/file_bytes.h"
#include "io/file_kind.h"
#include "io/profile_scan.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

// A network folder may be away for so long.
constexpr std::chrono::milliseconds kAway{1500};
constexpr std::chrono::milliseconds kSlice{20};

std::string secondsText(std::chrono::milliseconds duration) {
  const auto tenths = duration.count() / 100;
  return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10)) + " s";
}

// Points as text that do not say how many they are end with a line end; a program that was interrupted seldom got
// there.
void requireEnd(const FileBytes& bytes) {
  const std::string_view text = bytes.text();
  if (text.ends_with('\n') || text.ends_with('\r') || detectFileKind(bytes.path()) != FileKind::TextPoints) return;
  TextScanner first(text, bytes.path());
  std::size_t fields = 0;
  while (fields < 3 && !first.fieldOnLine().empty()) ++fields;
  if (fields == 1 || fields == 2) return;
  throw InvalidInput(
      bytes.path() +
      ": has no line end behind its last point, so it may have ended early: wait until it is whole, save it "
      "again, or let it begin with its columns and rows");
}

std::uint64_t hashOf(const FileBytes& bytes) {
  ContentHash hash;
  hash.add(bytes.text());
  return hash.value();
}

std::string nameOf(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

FolderSensor::FolderSensor(FolderSensorOptions options, std::shared_ptr<const ScannerProfile> profile)
    : options_(std::move(options)), profile_(std::move(profile)), watch_(options_.folder, options_.rest) {}

std::string FolderSensor::identity() const {
  return "folder " + options_.folder;
}

void FolderSensor::open(const Progress& progress) {
  progress.checkpoint(0.0);
  std::error_code failed;
  if (!std::filesystem::is_directory(options_.folder, failed))
    throw DeviceError(identity() + ": there is no such folder" + (failed ? " (" + failed.message() + ")" : "") +
                      "; make it, or name the one that the scanner's program writes to");
  try {
    static_cast<void>(watch_.look());
  } catch (const IoError& e) {
    throw DeviceError(std::string(e.what()) + ": the folder cannot be read; give yourself the right to read it");
  }
  open_ = true;
}

std::optional<std::string> FolderSensor::notReady() const {
  if (!open_) return "it is not open";
  return std::nullopt;
}

void FolderSensor::announceMove() {
  if (options_.existing) return;
  try {
    refuseInterrupted();
    if (!interrupted_) refuseLeftOver();
    left_ = watch_.beginAnew();
    if (!interrupted_) left_.clear();
    begun_ = true;
  } catch (const IoError&) {
    begun_ = false;  // capture says so, when it is still so then
  }
}

// What came beside the file that was taken is of the place that the table leaves now.
void FolderSensor::refuseLeftOver() {
  const std::string taken = nameOf(lastFile());
  if (taken.empty()) return;
  for (const WatchedFile& file : watch_.look())
    refuse(file.path, file.path + ": came beside " + taken +
                          ", which was taken, before the table was turned on: scan again if it is of another position");
}

// Or its move was given up, so that nobody knows which place it is of.
void FolderSensor::refuseInterrupted() {
  for (const std::string& path : std::exchange(left_, {}))
    refuse(path, path +
                     ": came for a scan that was stopped, and the table has turned since: scan again, or save it again "
                     "if it is of where the table stands now");
}

void FolderSensor::standAt(const ReachedPose& pose) {
  const bool stayed =
      !options_.tableAlwaysTurns && !pose.movedUntil && pose_ && pose_->matrix() == pose.T_table_scanner.matrix();
  pose_ = pose.T_table_scanner;
  if (stayed) watch_.takeBack(std::exchange(left_, {}));
  refuseInterrupted();
  if (!begun_ || !pose.movedUntil) return;
  try {
    for (const std::string& path : watch_.dismissBegunBefore(*pose.movedUntil))
      refuse(path, path + ": was begun while the table still turned, so it shows no position: scan again");
  } catch (const IoError&) {
    begun_ = false;  // as in announceMove
  }
}

RangeImage FolderSensor::capture(const Progress& progress) {
  if (!open_) throw DeviceError(identity() + ": it is not open");
  const bool begun = options_.existing || begun_ || interrupted_;
  begun_ = false;
  interrupted_ = true;
  RangeImage image = waitForScan(begun, progress);
  interrupted_ = false;
  return image;
}

RangeImage FolderSensor::waitForScan(bool begun, const Progress& progress) {
  const auto start = Clock::now();
  auto heard = start;
  while (true) {
    try {
      if (!begun) watch_.begin();
      begun = true;
      if (auto image = takeOne(progress)) return std::move(*image);
      heard = Clock::now();
    } catch (const IoError& e) {
      if (Clock::now() - heard > kAway)
        throw DeviceError(std::string(e.what()) +
                          ": the folder is gone or cannot be read; bring it back and scan again, nothing is lost");
    }
    const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
    if (options_.deadline && waited > *options_.deadline) tooLate();
    const double fraction =
        options_.deadline ? static_cast<double>(waited.count()) / static_cast<double>(options_.deadline->count()) : 0.0;
    progress.part(0.0, 1.0, waitingText()).checkpoint(std::min(fraction, 1.0));
    const auto until = Clock::now() + options_.interval;
    while (Clock::now() < until && !progress.stopRequested()) std::this_thread::sleep_for(kSlice);
  }
}

std::optional<RangeImage> FolderSensor::takeOne(const Progress& progress) {
  for (const WatchedFile& file : watch_.look())
    if (auto image = take(file, progress)) return image;
  return std::nullopt;
}

std::optional<RangeImage> FolderSensor::take(const WatchedFile& file, const Progress& progress) {
  try {
    const FileBytes bytes(file.path);
    const std::uint64_t hash = hashOf(bytes);
    const auto same = taken_.find(hash);
    if (same != taken_.end()) {
      if (same->second != file.path)
        refuse(file.path, file.path + ": has the content of " + nameOf(same->second) + ", which was taken already");
      watch_.dismiss(file);
      return std::nullopt;
    }
    requireEnd(bytes);
    RangeImage image = readScan(file.path, *profile_, options_.reading,
                                progress.part(0.0, 1.0, "reading " + nameOf(file.path)), pose_);
    // What was written to meanwhile is looked at again when it has come to rest.
    if (stampOf(file.path) != file.stamp) return std::nullopt;
    // The last moment at which a stop leaves it for the next scan.
    progress.part(0.0, 1.0, takenText(file)).checkpoint(1.0);
    watch_.dismiss(file);
    taken_.emplace(hash, file.path);
    const std::lock_guard lock(mutex_);
    lastFile_ = file.path;
    refused_.erase(file.path);
    lastRefused_.clear();
    return image;
  } catch (const UnansweredQuestion& e) {
    watch_.keep(file);
    refuse(file.path, e.what());
    throw DeviceError(e.what());
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    watch_.dismiss(file);
    refuse(file.path, e.what());
  }
  return std::nullopt;
}

void FolderSensor::refuse(const std::string& path, std::string reason) {
  const std::lock_guard lock(mutex_);
  lastRefused_ = reason;
  refused_[path] = std::move(reason);
}

std::string FolderSensor::waitingText() const {
  const std::lock_guard lock(mutex_);
  const std::string text = "waiting for a range file in " + options_.folder;
  return lastRefused_.empty() ? text : text + "; not taken: " + lastRefused_;
}

// Which file was taken, and which wait.
std::string FolderSensor::takenText(const WatchedFile& file) {
  std::string others;
  try {
    for (const WatchedFile& other : watch_.look())
      if (other.path != file.path) others += (others.empty() ? "" : ", ") + nameOf(other.path);
  } catch (const IoError&) {
    // The folder went away behind the file: that is said when the next one is waited for.
  }
  return "took " + nameOf(file.path) + (others.empty() ? "" : "; more files wait: " + others);
}

void FolderSensor::tooLate() const {
  const std::lock_guard lock(mutex_);
  const std::string why = lastRefused_.empty()
                              ? "start the scan in the scanner's program, and look whether it writes there"
                              : "not taken: " + lastRefused_;
  throw DeviceError(identity() + ": no range file came within " + secondsText(*options_.deadline) + "; " + why);
}

std::vector<RefusedFile> FolderSensor::refused() const {
  const std::lock_guard lock(mutex_);
  std::vector<RefusedFile> files;
  for (const auto& [path, reason] : refused_) files.push_back({path, reason});
  return files;
}

std::string FolderSensor::lastFile() const {
  const std::lock_guard lock(mutex_);
  return lastFile_;
}

}  // namespace vantage
