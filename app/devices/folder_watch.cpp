#include "devices/folder_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <tuple>

#include "base/errors.h"
#include "io/depth_png.h"
#include "io/file_kind.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 2;  // folders in folders
constexpr std::size_t kMostFiles = 100'000;

constexpr std::array<std::string_view, 9> kUnfinished{"part",       "tmp",      "temp", "partial", "filepart",
                                                      "crdownload", "download", "swp",  "writing"};
constexpr std::array<std::string_view, 21> kOthers{"lock", "lck", "log",  "json", "xml", "ini",  "db",
                                                   "bak",  "jpg", "jpeg", "bmp",  "gif", "tif",  "tiff",
                                                   "mtl",  "md",  "html", "pdf",  "cfg", "yaml", "toml"};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool isUnfinished(const std::string& name) {
  return name.ends_with('~') || contains(kUnfinished, extensionOf(name));
}

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::chrono::nanoseconds age(const FileStamp& stamp) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now) - std::chrono::nanoseconds(stamp.modified);
}

}  // namespace

FileStamp stampOf(const std::string& path) {
  struct stat of {};
  if (::stat(path.c_str(), &of) != 0 || !S_ISREG(of.st_mode)) return {};
  FileStamp stamp{
      of.st_dev, of.st_ino, static_cast<std::uint64_t>(of.st_size), nanoseconds(of.st_mtim), nanoseconds(of.st_ctim),
      0};
  if (extensionOf(path) == "png") {
    const std::string beside = intrinsicsBeside(path);
    struct stat other {};
    if (!beside.empty() && ::stat(beside.c_str(), &other) == 0) stamp.beside = nanoseconds(other.st_mtim);
  }
  return stamp;
}

bool FolderWatch::isIgnored(const std::string& name) {
  const std::string lower = lowerCase(name);
  if (lower.empty() || lower.front() == '.' || isUnfinished(lower)) return true;
  if (lower.find("thumb") != std::string::npos || lower.find("preview") != std::string::npos) return true;
  return contains(kOthers, extensionOf(lower));
}

void FolderWatch::see(const std::string& path) {
  const FileStamp stamp = stampOf(path);
  if (stamp == FileStamp{}) return;
  Known& known = known_[path];
  known.seen = true;
  if (known.stamp == stamp) return;
  const bool isNew = known.stamp == FileStamp{};
  const auto before = unfinished_.find({stamp.device, stamp.inode});
  std::error_code gone;
  known.renamed = isNew && before != unfinished_.end() && !fs::exists(before->second, gone);
  known.stamp = stamp;
  known.since = std::chrono::steady_clock::now();
  if (isNew) known.barred = barred_.contains({stamp.device, stamp.inode});
  known.done = known.barred;
}

void FolderWatch::list() {
  std::error_code failed;
  fs::recursive_directory_iterator at(folder_, fs::directory_options::skip_permission_denied, failed);
  // With that option an unreadable folder looks empty.
  if (!failed) fs::directory_iterator(folder_, failed);
  if (failed) throw IoError(folder_, failed.message());
  for (auto& [path, known] : known_) known.seen = false;
  decltype(unfinished_) unfinished;
  std::size_t count = 0;
  while (at != fs::recursive_directory_iterator() && count++ < kMostFiles) {
    const std::string name = at->path().filename().string();
    std::error_code other;
    if (at->is_directory(other)) {
      if (name.starts_with('.') || at.depth() >= kDeepest) at.disable_recursion_pending();
    } else if (isUnfinished(lowerCase(name)) || name.starts_with('.')) {
      const FileStamp stamp = stampOf(at->path().string());
      unfinished[{stamp.device, stamp.inode}] = at->path().string();
    } else if (!isIgnored(name)) {
      see(at->path().string());
    }
    at.increment(failed);
    if (failed) throw IoError(folder_, failed.message());
  }
  unfinished_ = std::move(unfinished);
  std::erase_if(known_, [](const auto& item) { return !item.second.seen; });
}

void FolderWatch::begin() {
  list();
  for (auto& [path, known] : known_) {
    const auto old = age(known.stamp);
    const bool fresh = old < rest_ && old > -rest_;
    if (!known.kept && !fresh) known.done = true;
    known.kept = false;
  }
}

void FolderWatch::beginAnew() {
  list();
  for (auto& [path, known] : known_) {
    known.barred = !known.kept;
    if (known.barred) known.done = true;
    known.kept = false;
  }
  barred_.clear();
  for (const auto& [file, path] : unfinished_) barred_.insert(file);
}

std::vector<WatchedFile> FolderWatch::look() {
  list();
  std::vector<WatchedFile> files;
  const auto now = std::chrono::steady_clock::now();
  for (const auto& [path, known] : known_)
    if (!known.done && (known.renamed || now - known.since >= rest_)) files.push_back({path, known.stamp});
  std::sort(files.begin(), files.end(), [](const WatchedFile& a, const WatchedFile& b) {
    return std::tie(a.stamp.modified, a.path) < std::tie(b.stamp.modified, b.path);
  });
  return files;
}

}  // namespace vantage
