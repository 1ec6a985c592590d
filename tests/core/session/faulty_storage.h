#pragma once

namespace vantage::testing {

/// While it lives, databases that are opened write through it, and it can be told to let the disk run full.
class FaultyStorage {
 public:
  FaultyStorage();
  ~FaultyStorage();
  FaultyStorage(const FaultyStorage&) = delete;
  FaultyStorage& operator=(const FaultyStorage&) = delete;

  /// So many writes succeed, all after them fail: the disk is full.
  void fillAfter(int writes);
  /// There is room again.
  void heal();
};

}  // namespace vantage::testing
