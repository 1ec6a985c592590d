#include "io/lzf.h"

#include "base/errors.h"

namespace vantage {
namespace {

// The most that one byte of a block can stand for.
constexpr std::size_t kMostGrowth = 264;

class LzfReader {
 public:
  LzfReader(std::string_view packed, std::size_t size, const std::string& what)
      : packed_(packed), size_(size), what_(what) {}

  std::string unpack() {
    if (size_ / kMostGrowth > packed_.size()) fail();
    out_.reserve(size_);
    while (at_ < packed_.size()) {
      const std::size_t control = byte();
      if (control < 32) {
        copyLiteral(control + 1);
      } else {
        copyEarlier(control);
      }
    }
    if (out_.size() != size_) fail();
    return std::move(out_);
  }

 private:
  std::size_t byte() {
    if (at_ >= packed_.size()) fail();
    return static_cast<unsigned char>(packed_[at_++]);
  }

  void copyLiteral(std::size_t count) {
    if (count > packed_.size() - at_ || count > size_ - out_.size()) fail();
    out_.append(packed_.substr(at_, count));
    at_ += count;
  }

  // What was written before, again; it may overlap with what it makes.
  void copyEarlier(std::size_t control) {
    std::size_t count = control >> 5U;
    if (count == 7) count += byte();
    count += 2;
    const std::size_t back = ((control & 0x1fU) << 8U) + byte() + 1;
    if (back > out_.size() || count > size_ - out_.size()) fail();
    for (std::size_t i = 0; i < count; ++i) out_ += out_[out_.size() - back];
  }

  [[noreturn]] void fail() const {
    throw InvalidInput(what_ + " is damaged: it does not unpack to the " + std::to_string(size_) + " bytes expected");
  }

  std::string_view packed_;
  std::size_t size_;
  const std::string& what_;
  std::size_t at_ = 0;
  std::string out_;
};

}  // namespace

std::string unpackLzf(std::string_view packed, std::size_t size, const std::string& what) {
  return LzfReader(packed, size, what).unpack();
}

}  // namespace vantage
