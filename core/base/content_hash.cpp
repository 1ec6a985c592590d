#include "base/content_hash.h"

#include <cstring>

namespace vantage {
namespace {

// Of an odd number, modulo 2^64 (Newton's iteration; every step doubles the digits that are right).
constexpr std::uint64_t inverse(std::uint64_t odd) {
  std::uint64_t x = odd;
  for (int i = 0; i < 5; ++i) x *= 2 - odd * x;
  return x;
}

// Undoes mixedBits.
constexpr std::uint64_t unmixedBits(std::uint64_t z) {
  z = (z ^ (z >> 31) ^ (z >> 62)) * inverse(0x94d049bb133111ebULL);
  z = (z ^ (z >> 27) ^ (z >> 54)) * inverse(0xbf58476d1ce4e5b9ULL);
  return z ^ (z >> 30) ^ (z >> 60);
}
static_assert(unmixedBits(mixedBits(0x0123456789abcdefULL)) == 0x0123456789abcdefULL);

}  // namespace

void ContentHash::add(std::span<const std::byte> bytes) {
  value_ = mixedBits(value_ ^ bytes.size());
  for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data(), sizeof word);
    value_ = (value_ ^ word) * 0x9fb21c651e98df25ULL;
    value_ ^= value_ >> 29;
  }
  std::uint64_t rest = 0;
  if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
  value_ = mixedBits(value_ ^ rest);
}

ContentHash ContentHash::before(std::uint64_t value, std::span<const std::byte> last) {
  std::uint64_t rest = 0;
  if (!last.empty()) std::memcpy(&rest, last.data(), last.size());
  ContentHash hash;
  hash.value_ = unmixedBits(unmixedBits(unmixedBits(value)) ^ rest) ^ last.size();
  return hash;
}

std::string hashText(std::uint64_t hash) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = kDigits[hash & 15];
  return text;
}

}  // namespace vantage
