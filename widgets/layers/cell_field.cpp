#include "layers/cell_field.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(PositionalSpace)
};

// Whether a cell's direction lies in the window.
bool inside(const PositionalCell& cell, const PositionalSpaceShape& shape,
            const std::optional<DirectionWindow>& window) {
  if (!window) return true;
  const double step = kPi / shape.directions;
  const auto off = [&](int index, double wanted) {
    return std::abs((index + 0.5) * step - 0.5 * kPi - wanted) > window->halfWidth + 0.5 * step;
  };
  return !off(cell.phi, window->phi) && !off(cell.psi, window->psi);
}

void sumImage(const PositionalImage& image, const ScannerImages& images, const PositionalViewOptions& options,
              CellField& field) {
  for (std::uint32_t number = 0; number < image.sums.size(); ++number) {
    if (image.sums[number] == 0) continue;
    const PositionalCell cell = images.cell(number);
    if (inside(cell, field.shape, options.direction))
      field.values[field.numberOf({cell.row, cell.column})] += image.at(number);
  }
}

void countPositions(const ScannerImages& images, const PositionalViewOptions& options, CellField& field) {
  const int first = options.position.value_or(0);
  const int last = options.position.value_or(images.positions() - 1);
  for (int position = std::max(0, first); position <= std::min(last, images.positions() - 1); ++position)
    for (const std::uint32_t number : images.image(position)) {
      const PositionalCell cell = images.cell(number);
      if (inside(cell, field.shape, options.direction)) field.values[field.numberOf({cell.row, cell.column})] += 1.0;
    }
}

QString titleOf(const PositionalViewOptions& options) {
  switch (options.kind) {
    case PositionalImageKind::Void:
      return Text::tr("P_v: void");
    case PositionalImageKind::Seen:
      return Text::tr("P_s: surface already seen");
    case PositionalImageKind::Scanner:
      break;
  }
  return options.position ? Text::tr("P_c: rays of position %1").arg(*options.position)
                          : Text::tr("P_c: rays of all positions");
}

}  // namespace

std::optional<CellField> cellField(const ViewSnapshot& snapshot, const PositionalViewOptions& options) {
  if (!snapshot.scannerImages) return std::nullopt;
  if (options.kind != PositionalImageKind::Scanner && !snapshot.planImages) return std::nullopt;
  CellField field;
  field.shape = snapshot.scannerImages->grid().shape();
  field.values.assign(static_cast<std::size_t>(field.shape.rows) * static_cast<std::size_t>(field.shape.columns), 0.0);
  field.title = titleOf(options);
  field.unit = options.kind == PositionalImageKind::Scanner ? Text::tr("positions") : QStringLiteral("mm²");
  field.map = options.kind == PositionalImageKind::Seen ? ColourMap::Cividis : ColourMap::Viridis;
  if (options.kind == PositionalImageKind::Void)
    sumImage(snapshot.planImages->voids, *snapshot.scannerImages, options, field);
  else if (options.kind == PositionalImageKind::Seen)
    sumImage(snapshot.planImages->seen, *snapshot.scannerImages, options, field);
  else
    countPositions(*snapshot.scannerImages, options, field);
  field.maximum = *std::max_element(field.values.begin(), field.values.end());
  return field;
}

}  // namespace vantage
