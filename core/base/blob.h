#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/errors.h"

namespace vantage {

/// A value whose bytes in memory are all that it is: numbers, enums, arrays and structs of them, points.
template <typename T>
concept PlainValue = std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T> && !std::is_pointer_v<T>;

/// Writes plain values one after the other, as in memory (little endian), for files.
class BlobWriter {
 public:
  template <PlainValue T>
  void value(const T& v) {
    append(std::as_bytes(std::span(&v, 1)));
  }

  /// The count, then the items.
  template <PlainValue T>
  void list(const std::vector<T>& items) {
    value(static_cast<std::uint64_t>(items.size()));
    append(std::as_bytes(std::span(items)));
  }

  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void append(std::span<const std::byte> more) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + more.size());
    if (!more.empty()) std::memcpy(bytes_.data() + end, more.data(), more.size());
  }

  std::vector<std::byte> bytes_;
};

/// Reads what BlobWriter wrote. Never reads past the end: @throws InvalidInput naming `what` when the blob is shorter
/// than it says.
class BlobReader {
 public:
  BlobReader(std::span<const std::byte> bytes, std::string what) : bytes_(bytes), what_(std::move(what)) {}

  template <PlainValue T>
  [[nodiscard]] T value() {
    T v{};
    take(&v, sizeof v);
    return v;
  }

  template <PlainValue T>
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
