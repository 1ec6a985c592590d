#include "cli/point_arguments.h"

#include <cmath>
#include <optional>
#include <vector>

namespace vantage {
namespace {

// The numbers of a list with commas; nothing when one is none, or not finite.
std::optional<std::vector<double>> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, ',')) {
    double number = 0.0;
    if (!CLI::detail::lexical_cast(part, number) || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

CLI::Validator pointText() {
  return {[](std::string& text) {
            const auto numbers = numbersOf(text);
            return numbers && numbers->size() == 3 ? std::string() : "'" + text + "' is no point X,Y,Z";
          },
          "X,Y,Z"};
}

Vec3 pointOf(const std::string& text) {
  const std::vector<double> numbers = numbersOf(text).value_or(std::vector<double>(3, 0.0));
  return {numbers[0], numbers[1], numbers[2]};
}

CLI::Validator planeText() {
  return {[](std::string& text) {
            const auto numbers = numbersOf(text);
            const bool isPlane =
                numbers && numbers->size() == 4 && Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]).norm() > 0.0;
            return isPlane ? std::string() : "'" + text + "' is no plane NX,NY,NZ,D with a normal";
          },
          "NX,NY,NZ,D"};
}

SurfacePlane planeOf(const std::string& text) {
  const std::vector<double> numbers = numbersOf(text).value_or(std::vector<double>(4, 1.0));
  const Vec3 normal(numbers[0], numbers[1], numbers[2]);
  return {normal.normalized(), numbers[3] / normal.norm()};
}

CLI::Validator boxText() {
  return {[](std::string& text) {
            const auto n = numbersOf(text);
            const bool isBox = n && n->size() == 6 && (*n)[0] != (*n)[3] && (*n)[1] != (*n)[4] && (*n)[2] != (*n)[5];
            return isBox ? std::string() : "'" + text + "' is no box X1,Y1,Z1,X2,Y2,Z2 with a volume";
          },
          "X1,Y1,Z1,X2,Y2,Z2"};
}

BoundingBox boxOf(const std::string& text) {
  const std::vector<double> n = numbersOf(text).value_or(std::vector<double>(6, 0.0));
  BoundingBox box{{n[0], n[1], n[2]}, {n[0], n[1], n[2]}};
  box.extend({n[3], n[4], n[5]});
  return box;
}

}  // namespace vantage
