#include "positional_space/objective_sums.h"

#include <string>

#include "base/errors.h"

namespace vantage {

std::vector<double> intersect(const PositionalImage& image, const ScannerImages& scanner) {
  if (image.sums.size() != scanner.cellCount())
    throw InvalidInput("an image of " + std::to_string(image.sums.size()) +
                       " cells cannot be met with scanner images of " + std::to_string(scanner.cellCount()));
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

}  // namespace vantage
