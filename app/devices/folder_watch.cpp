#include "devices/folder_watch.h"

#include <fcntl.h>
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

std::int64_t nanoseconds(const statx_timestamp& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::chrono::nanoseconds age(const FileStamp& stamp) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now) - std::chrono::nanoseconds(stamp.modified);
}

}  // namespace

FileStamp stampOf(const std::string& path) {
  struct statx of {};
  if (::statx(AT_FDCWD, path.c_str(), 0, STATX_BASIC_STATS | STATX_BTIME, &of) != 0 || !S_ISREG(of.stx_mode)) return {};
  FileStamp stamp;
  stamp.device = std::uint64_t{of.stx_dev_major} << 32 | of.stx_dev_minor;
  stamp.inode = of.stx_ino;
  stamp.size = of.stx_size;
  stamp.modified = nanoseconds(of.stx_mtime);
  if ((of.stx_mask & STATX_BTIME) != 0) stamp.made = nanoseconds(of.stx_btime);
  stamp.changed = nanoseconds(of.stx_ctime);
  if (extensionOf(path) == "png") {
    const std::string beside = intrinsicsBeside(path);
    struct statx other {};
    if (!beside.empty() && ::statx(AT_FDCWD, beside.c_str(), 0, STATX_MTIME, &other) == 0)
      stamp.beside = nanoseconds(other.stx_mtime);
  }
  return stamp;
}

bool FolderWatch::isIgnored(const std::string& name) {
  const std::string lower = lowerCase(name);
  if (lower.empty() || lower.front() == '.' || isUnfinished(lower)) return true;
  if (lower.find("thumb") != std::string::npos || lower.find("preview") != std::string::npos) return true;
  return contains(kOthers, extensionOf(lower));
}

// Was modified just now.
bool FolderWatch::isFresh(const FileStamp& stamp) const {
  const auto old = age(stamp);
  return old < rest_ && old > -rest_;
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
    if (!known.kept && !isFresh(known.stamp)) known.done = true;
    known.kept = false;
  }
}

std::vector<std::string> FolderWatch::beginAnew() {
  list();
  const auto now = std::chrono::steady_clock::now();
  std::vector<std::string> dismissed;
  for (auto& [path, known] : known_) {
    if (!known.done && !known.kept) dismissed.push_back(path);
    const bool written = known.renamed || now - known.since >= rest_ || !isFresh(known.stamp);
    known.barred = !known.kept && !written;
    if (!known.kept) known.done = true;
    known.kept = false;
    known.old = true;
  }
  begunAnew_ = now;
  barred_.clear();
  for (const auto& [file, path] : unfinished_) barred_.insert(file);
  return dismissed;
}

void FolderWatch::takeBack(const std::vector<std::string>& paths) {
  barred_.clear();
  for (const std::string& path : paths)
    if (const auto known = known_.find(path); known != known_.end()) known->second.done = known->second.barred = false;
}

std::vector<std::string> FolderWatch::dismissBegunBefore(std::chrono::system_clock::time_point moment) {
  list();
  const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(moment.time_since_epoch()).count();
  std::vector<std::string> dismissed;
  for (auto& [path, known] : known_) {
    const bool came = !known.old || known.since > begunAnew_;
    const bool isNew = !known.old && known.stamp.made != 0;
    if (known.done || !came || (isNew ? known.stamp.made : known.stamp.modified) >= since) continue;
    known.done = true;
    known.barred = true;
    dismissed.push_back(path);
  }
  return dismissed;
}

std::vector<WatchedFile> FolderWatch::look() {
  list();
  std::vector<WatchedFile> files;
  const auto now = std::chrono::steady_clock::now();
  for (auto& [path, known] : known_) {
    const bool rests = now - known.since >= rest_;
    if (rests) known.barred = false;
    if (!known.done && (known.renamed || rests)) files.push_back({path, known.stamp});
  }
  std::sort(files.begin(), files.end(), [](const WatchedFile& a, const WatchedFile& b) {
    return std::tie(a.stamp.modified, a.path) < std::tie(b.stamp.modified, b.path);
  });
  return files;
}

}  // namespace vantage
