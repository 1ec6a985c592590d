#include "layers/positional_links.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "look/legend.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(PositionalSpace)
};

// Directions in which occupied cells leave through one surface cell [rad].
struct Directions {
  int cells = 0;
  double lowPhi = 1e9;
  double highPhi = -1e9;
  double lowPsi = 1e9;
  double highPsi = -1e9;
};

Directions directionsOf(const ScannerImages& images, const MapCell& at) {
  const auto& data = images.data();
  const int columnsPerPeriod = data.shape.columns / data.periods;
  const auto surface = static_cast<std::size_t>(at.row) * static_cast<std::size_t>(columnsPerPeriod) +
                       static_cast<std::size_t>(at.column % columnsPerPeriod);
  const double step = kPi / data.shape.directions;
  Directions result;
  for (std::uint32_t k = data.surfaceStart[surface]; k < data.surfaceStart[surface + 1]; ++k) {
    const double phi = (data.direction[k][0] + 0.5) * step - 0.5 * kPi;
    const double psi = (data.direction[k][1] + 0.5) * step - 0.5 * kPi;
    ++result.cells;
    result.lowPhi = std::min(result.lowPhi, phi);
    result.highPhi = std::max(result.highPhi, phi);
    result.lowPsi = std::min(result.lowPsi, psi);
    result.highPsi = std::max(result.highPsi, psi);
  }
  return result;
}

QString angle(double value) {
  return QString::number(std::lround(degrees(value))) + QChar(0x00B0);
}

}  // namespace

PositionalLinks::PositionalLinks(const ScannerImages& scannerImages, const PlanImages& planImages) {
  const auto columns = static_cast<std::uint32_t>(scannerImages.grid().columns());
  for (std::uint32_t patch = 0; patch < planImages.voids.sourceCount(); ++patch) {
    for (const Sighting& sighting : planImages.voids.sightingsOf(patch)) {
      const PositionalCell cell = scannerImages.cell(sighting.cell);
      cellsOfPatch_.push_back(
          {patch, static_cast<std::uint32_t>(cell.row) * columns + static_cast<std::uint32_t>(cell.column)});
    }
  }
  std::sort(cellsOfPatch_.begin(), cellsOfPatch_.end());
  cellsOfPatch_.erase(std::unique(cellsOfPatch_.begin(), cellsOfPatch_.end()), cellsOfPatch_.end());
  patchesOfCell_.reserve(cellsOfPatch_.size());
  for (const Link& link : cellsOfPatch_) patchesOfCell_.push_back({link.to, link.from});
  std::sort(patchesOfCell_.begin(), patchesOfCell_.end());
}

std::vector<std::uint32_t> PositionalLinks::linked(const std::vector<Link>& links, std::uint32_t from) {
  std::vector<std::uint32_t> result;
  for (auto link = std::lower_bound(links.begin(), links.end(), Link{from, 0});
       link != links.end() && link->from == from; ++link)
    result.push_back(link->to);
  return result;
}

std::vector<std::uint32_t> PositionalLinks::patchesThrough(std::uint32_t surfaceCell) const {
  return linked(patchesOfCell_, surfaceCell);
}

std::vector<std::uint32_t> PositionalLinks::cellsOf(std::uint32_t patch) const {
  return linked(cellsOfPatch_, patch);
}

QStringList describeCell(const ViewSnapshot& snapshot, const CellField& field, const MapCell& at) {
  const SurfaceCell& cell = snapshot.scannerImages->grid().surfaceCell(at.row, at.column);
  const double azimuth = std::atan2(cell.centre.y(), cell.centre.x());
  QStringList lines;
  lines << Text::tr("a window at %1 around, %2 mm up: %3 %4")
               .arg(angle(azimuth < 0.0 ? azimuth + 2.0 * kPi : azimuth), QString::number(std::lround(cell.centre.z())),
                    shortNumber(field.at(at)), field.unit);
  const Directions directions = directionsOf(*snapshot.scannerImages, at);
  lines << (directions.cells == 0
                ? Text::tr("no ranging ray leaves through it")
                : Text::tr("the scanner looks through it from %1 to %2 aside")
                          .arg(angle(directions.lowPhi), angle(directions.highPhi)) +
                      (directions.highPsi - directions.lowPsi < radians(0.5)
                           ? QString()
                           : Text::tr(", %1 to %2 up").arg(angle(directions.lowPsi), angle(directions.highPsi))));
  return lines;
}

}  // namespace vantage
