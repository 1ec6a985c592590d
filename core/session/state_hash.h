#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// A 64-bit number for a sequence of values: equal contents, equal numbers, on every machine of the same byte order.
/// Not meant against forgery.
class ContentHash {
 public:
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  void add(const Pose& pose);
  template <typename T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { add(std::as_bytes(std::span(&value, 1))); }
  template <typename T>
  void add(const std::vector<T>& items) {
    add(std::as_bytes(std::span(items)));
  }

  [[nodiscard]] std::uint64_t value() const;

 private:
  std::uint64_t value_ = 0x9e3779b97f4a7c15ULL;
};

/// Everything that decides how a session goes on: settings, scans, poses, records, plans and the model. Times do not
/// count. Of plans before the current one only the scores do.
[[nodiscard]] std::uint64_t stateHash(const AcquisitionState& state);

/// 16 hexadecimal digits.
[[nodiscard]] std::string hashText(std::uint64_t hash);

/// Of positions and triangles.
[[nodiscard]] std::uint64_t contentHash(const Mesh& mesh);

}  // namespace vantage
