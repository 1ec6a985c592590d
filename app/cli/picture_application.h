#pragma once

#include <QGuiApplication>
#include <array>
#include <optional>

namespace vantage {

/// What text in pictures needs: an application of Qt, here one without a display. What Qt says of the surroundings that
/// it finds is dropped: pictures do not depend on them. At most one at a time.
class PictureApplication {
 public:
  PictureApplication();

 private:
  std::array<char, 12> name_{"vantage-cli"};
  char* arguments_ = name_.data();
  int count_ = 1;
  std::optional<QGuiApplication> application_;
};

}  // namespace vantage
