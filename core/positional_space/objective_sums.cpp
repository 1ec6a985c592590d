#include "positional_space/objective_sums.h"

#include <algorithm>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

void checkSame(const PositionalImage& image, const ScannerImages& scanner) {
  if (image.sums.size() != scanner.cellCount())
    throw InvalidInput("an image of " + std::to_string(image.sums.size()) +
                       " cells cannot be met with scanner images of " + std::to_string(scanner.cellCount()));
}

}  // namespace

std::vector<double> intersect(const PositionalImage& image, const ScannerImages& scanner) {
  checkSame(image, scanner);
  const ScannerImages::Data& data = scanner.data();
  const std::size_t total = scanner.cellCount();
  std::vector<double> sums;
  sums.reserve(static_cast<std::size_t>(scanner.positions()));
  for (int position = 0; position < scanner.positions(); ++position) {
    const ScannerImages::Shift shift = scanner.shiftOf(position);
    std::int64_t sum = 0;
    for (std::uint32_t k = data.imageStart[shift.image]; k < data.imageStart[shift.image + 1]; ++k) {
      const std::size_t cell = data.imageCells[k] + shift.offset;
      sum += image.sums[cell < total ? cell : cell - total];
    }
    sums.push_back(static_cast<double>(sum) * PositionalImage::kUnit);
  }
  return sums;
}

std::vector<std::vector<SeenSource>> seenSources(const PositionalImage& image, const ScannerImages& scanner) {
  checkSame(image, scanner);
  if (!image.keepsSightings()) throw InvalidInput("the image does not keep which sources it was made from");
  std::vector<std::vector<SeenSource>> seen(static_cast<std::size_t>(scanner.positions()));
  for (std::size_t source = 0; source < image.sourceCount(); ++source) {
    for (const Sighting& sighting : image.sightingsOf(source)) {
      for (const int position : scanner.positionsOf(sighting.cell)) {
        auto& list = seen[static_cast<std::size_t>(position)];
        if (list.empty() || list.back().source != source)
          list.push_back({static_cast<std::uint32_t>(source), sighting.confidence});
        else
          list.back().confidence = std::max(list.back().confidence, sighting.confidence);
      }
    }
  }
  return seen;
}

}  // namespace vantage
