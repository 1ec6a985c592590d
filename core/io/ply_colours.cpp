#include "io/ply_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace vantage {
namespace {

constexpr std::array<std::string_view, 3> kChannels{"red", "green", "blue"};

}  // namespace

std::vector<Colour> vertexColours(const PlyDocument& document) {
  std::array<const PlyColumn*, 3> columns{};
  std::array<double, 3> full{};
  for (std::size_t k = 0; k < 3; ++k) {
    columns[k] = document.find("vertex", kChannels[k]);
    if (columns[k] == nullptr || !columns[k]->start.empty()) return {};
    const PlyType type = document.header().find("vertex")->find(kChannels[k])->type;
    const bool share = type == PlyType::Float32 || type == PlyType::Float64;
    full[k] = share ? 255.0 : type == PlyType::UInt16 ? 255.0 / 65535.0 : 1.0;
  }
  std::vector<Colour> colours(columns[0]->values.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = full[k] * columns[k]->values[i];
      colours[i][k] = static_cast<std::uint8_t>(value >= 0.0 ? std::lround(std::min(value, 255.0)) : 0);
    }
  return colours;
}

}  // namespace vantage
