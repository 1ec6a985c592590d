#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/errors.h"
#include "geometry/vectors.h"

namespace vantage {

/// Writes plain values one after the other (little endian, as in memory) for a column of the session file.
class BlobWriter {
 public:
  template <typename T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* bytes = reinterpret_cast<const std::byte*>(&v);
    bytes_.insert(bytes_.end(), bytes, bytes + sizeof v);
  }

  /// The count, then the items.
  template <typename T>
  void list(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(items.size(), std::as_bytes(std::span(items)));
  }

  /// As a list of three doubles each.
  void list(const std::vector<Vec3>& points) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    append(points.size(), std::as_bytes(std::span(points)));
  }

  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void append(std::uint64_t count, std::span<const std::byte> items) {
    value(count);
    bytes_.insert(bytes_.end(), items.begin(), items.end());
  }

  std::vector<std::byte> bytes_;
};

/// Reads what BlobWriter wrote. Never reads past the end: @throws InvalidInput naming `what` when the blob is shorter
/// than it says.
class BlobReader {
 public:
  BlobReader(std::span<const std::byte> bytes, std::string what) : bytes_(bytes), what_(std::move(what)) {}

  template <typename T>
  [[nodiscard]] T value() {
    T v;
    take(&v, sizeof v);
    return v;
  }

  template <typename T>
  [[nodiscard]] std::vector<T> list() {
    const auto count = value<std::uint64_t>();
    if (count > (bytes_.size() - at_) / sizeof(T)) fail();
    std::vector<T> items(count);
    take(items.data(), items.size() * sizeof(T));
    return items;
  }

  /// @throws InvalidInput when something is left over.
  void finish() const {
    if (at_ != bytes_.size()) fail();
  }

 private:
  void take(void* target, std::size_t size) {
    if (size > bytes_.size() - at_) fail();
    if (size > 0) std::memcpy(target, bytes_.data() + at_, size);
    at_ += size;
  }
  [[noreturn]] void fail() const { throw InvalidInput(what_ + " is damaged: its length does not fit its contents"); }

  std::span<const std::byte> bytes_;
  std::string what_;
  std::size_t at_ = 0;
};

}  // namespace vantage
