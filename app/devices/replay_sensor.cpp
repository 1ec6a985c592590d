#include "devices/replay_sensor.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

#include "base/errors.h"
#include "devices/folder_watch.h"
#include "io/profile_scan.h"
#include "io/text_scanner.h"
#include "session/session.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// Rays of two scanners that are the same but for rounding [mm].
constexpr double kSameRay = 1e-3;

std::optional<int> positionIn(const std::string& name) {
  const std::string lower = lowerCase(name);
  for (const std::string word : {"position", "pos"}) {
    std::size_t at = lower.rfind(word);
    if (at == std::string::npos) continue;
    at += word.size();
    if (at < lower.size() && (lower[at] == '_' || lower[at] == '-' || lower[at] == ' ')) ++at;
    std::size_t end = at;
    while (end < lower.size() && end - at < 9 && std::isdigit(static_cast<unsigned char>(lower[end])) != 0) ++end;
    if (end > at) return std::stoi(lower.substr(at, end - at));
  }
  return std::nullopt;
}

// The four corners tell.
bool areSame(const RayGrid& a, const RayGrid& b) {
  if (&a == &b) return true;
  if (a.rows() != b.rows() || a.columns() != b.columns()) return false;
  for (const int r : {0, a.rows() - 1})
    for (const int c : {0, a.columns() - 1}) {
      const RangingRay& p = a.ray(a.index(r, c));
      const RangingRay& q = b.ray(b.index(r, c));
      if ((p.origin - q.origin).norm() > kSameRay || (p.direction - q.direction).norm() > kSameRay) return false;
    }
  return true;
}

}  // namespace

ReplaySensor::ReplaySensor(std::string source, std::shared_ptr<const ScannerProfile> profile,
                           ScanReadingOptions reading)
    : source_(std::move(source)), profile_(std::move(profile)), reading_(reading) {}

ReplaySensor::~ReplaySensor() = default;

void ReplaySensor::open(const Progress& progress) {
  if (!recorded_.empty()) return;
  try {
    std::error_code failed;
    if (fs::is_directory(source_, failed))
      listFolder();
    else
      listSession(progress);
  } catch (const Cancelled&) {
    close();
    throw;
  } catch (const std::exception& e) {
    close();
    throw DeviceError(identity() + ": " + e.what());
  }
  if (recorded_.empty())
    throw DeviceError(identity() + ": it has no scans; name a session or a folder with range files");
}

void ReplaySensor::listSession(const Progress& progress) {
  session_ = std::make_unique<Session>(Session::open(source_, SessionAccess::Read, progress.part(0.0, 0.5)));
  const std::int64_t count = session_->scanCount();
  for (std::int64_t number = 0; number < count; ++number) {
    progress.checkpoint(0.5 + 0.5 * static_cast<double>(number) / static_cast<double>(count));
    const auto scan = session_->scan(number);
    if (scan) recorded_.push_back({scan->station.position, number, {}});
  }
}

void ReplaySensor::listFolder() {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(source_))
    if (entry.is_regular_file() && !FolderWatch::isIgnored(entry.path().filename().string()))
      files.insert(entry.path().string());
  for (const std::string& file : files) recorded_.push_back({positionIn(fs::path(file).stem().string()), 0, file});
}

void ReplaySensor::close() noexcept {
  recorded_.clear();
  session_.reset();
}

std::optional<std::string> ReplaySensor::notReady() const {
  if (recorded_.empty()) return "it is not open";
  return std::nullopt;
}

ReplaySensor::Recorded& ReplaySensor::next() {
  const auto isFree = [&](const Recorded& r) {
    return !r.given && (!r.position || !pose_ || *r.position == pose_->position);
  };
  const auto found = std::find_if(recorded_.begin(), recorded_.end(), isFree);
  if (found != recorded_.end()) return *found;
  if (!pose_) throw DeviceError(identity() + ": all its scans were taken again; there is no further one");
  std::size_t here = 0;
  std::set<int> left;
  for (const Recorded& r : recorded_) {
    here += r.position == pose_->position ? 1U : 0U;
    if (!r.given && r.position) left.insert(*r.position);
  }
  std::string others = left.empty() ? "none is left of any other" : "there are some left of ";
  std::size_t named = 0;
  for (const int position : left)
    if (named++ < 10) others += (named > 1 ? ", " : "") + std::to_string(position);
  const std::string position = "position " + std::to_string(pose_->position);
  throw DeviceError(
      identity() + ": " +
      (here == 0 ? "it has no scan of " + position : "its scans of " + position + " were taken again already") + "; " +
      others + (left.size() > 10 ? ", ..." : "") + (left.empty() ? "" : ": choose one of these"));
}

RangeImage ReplaySensor::capture(const Progress& progress) {
  if (recorded_.empty()) throw DeviceError(identity() + ": it is not open");
  progress.part(0.0, 1.0, "reading a recorded scan").checkpoint(0.0);
  Recorded& recorded = next();
  try {
    RangeImage image = read(recorded, progress);
    recorded.given = true;
    return image;
  } catch (const Cancelled&) {
    throw;
  } catch (const DeviceError&) {
    throw;
  } catch (const Error& e) {
    throw DeviceError(identity() + ": " + e.what());
  }
}

RangeImage ReplaySensor::read(const Recorded& recorded, const Progress& progress) const {
  if (!recorded.file.empty()) {
    std::optional<Pose> T_table_scanner;
    if (pose_) T_table_scanner = pose_->T_table_scanner;
    return readScan(recorded.file, *profile_, reading_, progress, T_table_scanner);
  }
  const auto scan = session_->scan(recorded.number);
  if (!scan)
    throw DeviceError(identity() + ": its scan " + std::to_string(recorded.number) + " is damaged and cannot be read");
  if (profile_ && !areSame(*scan->rays, *profile_->rays))
    throw DeviceError(identity() + ": its scans have the rays of another scanner, " +
                      std::to_string(scan->rays->rows()) + " x " + std::to_string(scan->rays->columns()) +
                      "; choose the profile that the session was made with");
  RangeImage image;
  image.rays = profile_ ? profile_->rays : scan->rays;
  image.range = scan->range;
  image.colours = scan->colours;
  return image;
}

}  // namespace vantage
