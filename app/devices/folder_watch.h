#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vantage {

/// What tells that a file has changed.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;     ///< [bytes]
  std::int64_t modified = 0;  ///< [ns since the epoch]
  std::int64_t made = 0;      ///< likewise; 0 where the file system does not tell
  std::int64_t changed = 0;   ///< likewise, of name and rights
  std::int64_t beside = 0;    ///< likewise, when the file that belongs to it was modified; 0 without one

  bool operator==(const FileStamp&) const = default;
};

/// The stamp of a file; that of no file when it is missing.
[[nodiscard]] FileStamp stampOf(const std::string& path);

struct WatchedFile {
  std::string path;
  FileStamp stamp;
};

/// Looks into a folder, and folders in it, for files that somebody has finished writing. It asks the file system each
/// time, so that network folders work. Hidden files, unfinished ones (*.part, *.tmp, ...), locks, logs, thumbnails,
/// settings and pictures of other kinds are not looked at.
class FolderWatch {
 public:
  /// @param rest how long size and times of a file must have stayed as they are. One that had an unfinished file's name
  /// the last time is finished at once.
  FolderWatch(std::string folder, std::chrono::milliseconds rest) : folder_(std::move(folder)), rest_(rest) {}

  /// From now on only new and changed files are offered, those that were modified until just now among them, and those
  /// that are kept. @throws IoError as look
  void begin();

  /// The same before a move: what is there already, also what is still being written, is of an earlier scan and not
  /// offered any more, but for files that are kept, and for finished ones that are written anew.
  /// @return the names of what was offered or still being written until now. @throws IoError as look
  std::vector<std::string> beginAnew();

  /// Offers files again that beginAnew() dismissed: nothing has moved.
  void takeBack(const std::vector<std::string>& paths);

  /// Dismisses the files there are that came since beginAnew() and whose writing began before a moment.
  /// @return their names. @throws IoError as look
  std::vector<std::string> dismissBegunBefore(std::chrono::system_clock::time_point moment);

  /// The files that are finished and not dismissed, oldest first, of the same time by name.
  /// @throws IoError when the folder is not there or cannot be read
  [[nodiscard]] std::vector<WatchedFile> look();

  /// A file that is not offered again until it changes.
  void dismiss(const WatchedFile& file) { known_[file.path].done = true; }
  /// A file that is offered also when begin() comes before.
  void keep(const WatchedFile& file) { known_[file.path].kept = true; }

  /// Whether files of that name are not looked at.
  [[nodiscard]] static bool isIgnored(const std::string& name);

 private:
  struct Known {
    FileStamp stamp;
    std::chrono::steady_clock::time_point since;
    bool renamed = false;
    bool done = false;
    bool barred = false;  // is still being written: until it rests it is not offered when it changes, either
    bool old = false;     // was there when beginAnew() was called last
    bool kept = false;
    bool seen = false;
  };
  void list();
  [[nodiscard]] bool isFresh(const FileStamp& stamp) const;
  void see(const std::string& path);

  std::string folder_;
  std::chrono::milliseconds rest_;
  std::chrono::steady_clock::time_point begunAnew_;
  std::map<std::string, Known> known_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::string> unfinished_;  // by device and inode
  std::set<std::pair<std::uint64_t, std::uint64_t>> barred_;                   // of those when a move began
};

}  // namespace vantage
