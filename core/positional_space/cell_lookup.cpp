#include "positional_space/cell_lookup.h"

#include <numeric>

namespace vantage {
namespace {

// Slopes beyond any that a cell can have.
constexpr float kAnySlope = 1e9F;

}  // namespace

CellLookup::CellLookup(const ScannerImages& scanner, Lanes lanes) : lanes_(lanes) {
  const ScannerImages::Data& data = scanner.data();
  const int columns = data.shape.columns / data.periods;
  std::vector<std::uint32_t> order(data.cells.size());
  std::iota(order.begin(), order.end(), 0U);
  cells_.reserve(order.size());
  for (std::size_t s = 0; s + 1 < data.surfaceStart.size(); ++s) {
    const std::uint32_t begin = data.surfaceStart[s];
    const std::uint32_t end = data.surfaceStart[s + 1];
    std::stable_sort(order.begin() + begin, order.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      return stepOf(folded(data.cells[a].slope[1]), kStepsUp) < stepOf(folded(data.cells[b].slope[1]), kStepsUp);
    });
    const auto& surface = scanner.grid().surfaceCell(static_cast<int>(s) / columns, static_cast<int>(s) % columns);
    for (std::uint32_t k = begin; k < end; ++k) addCell(data, surface, order[k]);
    addList(begin, end);
  }
  for (auto* list : {&reach_.lowAcross, &reach_.highAcross, &reach_.lowUp, &reach_.highUp})
    list->resize(cells_.size() + kFanLanes);
}

void CellLookup::addCell(const ScannerImages::Data& data, const SurfaceCell& surface, std::uint32_t number) {
  const OccupiedCell& cell = data.cells[number];
  const auto width = static_cast<float>(surface.widest());
  const auto height = static_cast<float>(surface.halfHeight);
  const float across = std::abs(cell.fan[0]) * width + std::abs(cell.fan[1]) * height;
  const float up = std::abs(cell.fan[2]) * width + std::abs(cell.fan[3]) * height;
  const auto squared = [&](double range) {
    const double left = std::max(range - static_cast<double>(cell.sourceDistance), 0.0);
    return static_cast<float>(left * left);
  };
  cells_.push_back({cell.slope, cell.fan, {squared(data.minRange), squared(data.maxRange)}, number, cell.receiverSide});
  reach_.lowAcross.push_back(cell.slope[0] - across);
  reach_.highAcross.push_back(cell.slope[0] + across);
  reach_.lowUp.push_back(cell.slope[1] - up);
  reach_.highUp.push_back(cell.slope[1] + up);
}

void CellLookup::addList(std::uint32_t begin, std::uint32_t end) {
  List list;
  list.start = steps_.size();
  longest_ = std::max<std::size_t>(longest_, end - begin);
  list.all = {kAnySlope, -kAnySlope};
  auto stepUp = [&](std::uint32_t k) { return stepOf(folded(cells_[k].slope[1]), kStepsUp); };
  for (std::uint32_t k = begin; k < end; ++k) {
    const SlopeRange up{reach_.lowUp[k], reach_.highUp[k]};
    list.all.low = std::min(list.all.low, up.low);
    list.all.high = std::max(list.all.high, up.high);
    const float middle = folded(cells_[k].slope[1]);
    list.margin = std::max({list.margin, folded(up.high) - middle, middle - folded(up.low)});
  }
  if (begin < end) {
    list.firstUp = stepUp(begin);
    list.endUp = stepUp(end - 1) + 1;
  }
  std::uint32_t first = begin;
  for (int step = list.firstUp; step < list.endUp; ++step) {
    std::uint32_t last = first;
    while (last < end && stepUp(last) == step) ++last;
    addSteps(first, last);
    first = last;
  }
  lists_.push_back(list);
}

// For each step across, the smallest range of [first, last) with all cells whose fan reaches into it.
void CellLookup::addSteps(std::uint32_t first, std::uint32_t last) {
  const std::size_t start = steps_.size();
  steps_.resize(start + kStepsAcross, {last, first});
  for (std::uint32_t k = first; k < last; ++k) {
    const int lowest = stepOf(folded(reach_.lowAcross[k]), kStepsAcross);
    const int highest = stepOf(folded(reach_.highAcross[k]), kStepsAcross);
    for (int step = lowest; step <= highest; ++step) {
      auto& range = steps_[start + static_cast<std::size_t>(step)];
      range[0] = std::min(range[0], k);
      range[1] = std::max(range[1], k + 1);
    }
  }
  // From a step to a later one, the range runs from the beginning of the one to the end of the other, even if one of
  // them has no cells.
  for (std::size_t step = 1; step < kStepsAcross; ++step)
    steps_[start + step][1] = std::max(steps_[start + step][1], steps_[start + step - 1][1]);
  for (std::size_t step = kStepsAcross - 1; step-- > 0;)
    steps_[start + step][0] = std::min(steps_[start + step][0], steps_[start + step + 1][0]);
}

}  // namespace vantage
