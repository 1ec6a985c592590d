#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace vantage {

/// The finaliser of splitmix64, a bijection: every bit of the argument reaches every bit of the result, and 0 stays 0.
[[nodiscard]] constexpr std::uint64_t mixedBits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// A 64-bit number for a sequence of values: equal contents, equal numbers, on every machine of the same byte order.
/// The numbers are stored in files: what a sequence hashes to never changes. Not meant against forgery.
class ContentHash {
 public:
  /// The count, then the bytes.
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  template <typename T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { add(std::as_bytes(std::span(&value, 1))); }
  template <typename T>
  void add(const std::vector<T>& items) {
    add(std::as_bytes(std::span(items)));
  }

  [[nodiscard]] std::uint64_t value() const { return mixedBits(value_); }

  /// The hash that had this value once `last` was added: every step of hashing can be undone by who knows what was
  /// added. @pre last is shorter than 8 bytes
  [[nodiscard]] static ContentHash before(std::uint64_t value, std::span<const std::byte> last);

 private:
  std::uint64_t value_ = 0x9e3779b97f4a7c15ULL;
};

/// 16 hexadecimal digits.
[[nodiscard]] std::string hashText(std::uint64_t hash);

}  // namespace vantage
