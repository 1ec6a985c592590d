#include "faulty_storage.h"

#include <sqlite3.h>

#include <atomic>
#include <limits>
#include <map>

namespace vantage::testing {
namespace {

constexpr int kRoomForAll = std::numeric_limits<int>::max();

// SQLite calls plain functions: what they work on cannot be handed to them.
struct Disk {
  sqlite3_vfs* real = nullptr;
  sqlite3_vfs faulty{};
  // Databases and their logs are written by different tables of the same functions.
  std::map<const sqlite3_io_methods*, sqlite3_io_methods> faultyMethods;
  int (*realWrite)(sqlite3_file*, const void*, int, sqlite3_int64) = nullptr;
  std::atomic<int> writesLeft = kRoomForAll;
};

Disk& disk() {
  static Disk theDisk;
  return theDisk;
}

int faultyWrite(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  int left = disk().writesLeft;
  while (left != 0 && left != kRoomForAll && !disk().writesLeft.compare_exchange_weak(left, left - 1)) {
  }
  if (left == 0) return SQLITE_FULL;
  return disk().realWrite(file, data, size, offset);
}

int faultyOpen(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags, int* outFlags) {
  const int code = disk().real->xOpen(disk().real, name, file, flags, outFlags);
  if (code != SQLITE_OK || file->pMethods == nullptr) return code;
  sqlite3_io_methods& methods = disk().faultyMethods.try_emplace(file->pMethods, *file->pMethods).first->second;
  disk().realWrite = file->pMethods->xWrite;
  methods.xWrite = faultyWrite;
  file->pMethods = &methods;
  return code;
}

}  // namespace

FaultyStorage::FaultyStorage() {
  disk().real = sqlite3_vfs_find(nullptr);
  disk().faulty = *disk().real;
  disk().faulty.zName = "faulty";
  disk().faulty.xOpen = faultyOpen;
  sqlite3_vfs_register(&disk().faulty, 1);
}

FaultyStorage::~FaultyStorage() {
  heal();
  sqlite3_vfs_unregister(&disk().faulty);
  sqlite3_vfs_register(disk().real, 1);
}

void FaultyStorage::fillAfter(int writes) {
  disk().writesLeft = writes;
}

void FaultyStorage::heal() {
  disk().writesLeft = kRoomForAll;
}

}  // namespace vantage::testing
