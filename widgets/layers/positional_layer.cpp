#include "layers/positional_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr double kVeil = 0.13;
constexpr double kHighlightWidth = 2.0;
constexpr double kHighlightInFront = 6.0;

// Cells are drawn this much larger than they are, so that no light shows between them.
constexpr double kOverlap = 1.004;

// Corners of a cell, counter-clockwise seen from outside.
std::array<Vec3, 4> cornersOf(const SurfaceCell& cell) {
  const auto corner = [&](double across, double up) {
    const double half = cell.halfWidth * (1.0 - cell.taper * up * cell.halfHeight);
    return Vec3(cell.centre + kOverlap * (across * half * cell.across + up * cell.halfHeight * cell.up));
  };
  return {corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)};
}

}  // namespace

PositionalLayer::PositionalLayer(Scene& scene) : far_(makeActor()), near_(makeActor()), highlighted_(makeActor()) {
  scene.add(*far_);
  scene.add(*near_);
  scene.addLines(*highlighted_, kHighlightWidth);
  for (vtkActor* actor : {far_.Get(), near_.Get(), highlighted_.Get()}) setUnlit(*actor);
  far_->GetProperty()->SetFrontfaceCulling(true);
  near_->GetProperty()->SetBackfaceCulling(true);
  near_->GetProperty()->SetOpacity(kVeil);
  setInFront(*highlighted_, kHighlightInFront);
  setTheme(lightTheme());
}

void PositionalLayer::set(const PositionalSpaceGrid* grid, const CellField* field) {
  quads_.clear();
  caster_.reset();
  columns_ = 0;
  if (grid != nullptr) {
    for (const SurfaceCell& cell : grid->surfaceCells()) quads_.push_back(cornersOf(cell));
    columns_ = grid->columns();
    reach_ = 0.2 * grid->shape().radius;
    caster_.emplace(quadMesh(quads_));
  }
  if (field == nullptr || quads_.empty()) {
    for (vtkActor* actor : {far_.Get(), near_.Get()}) setData(*actor, nullptr);
    return;
  }
  std::vector<Rgb> colours;
  colours.reserve(quads_.size());
  for (const double value : field->values)
    colours.push_back(colourAt(field->map, field->maximum > 0.0 ? value / field->maximum : 0.0));
  const auto data = withCellColours(*toQuads(quads_), colours);
  setData(*far_, data);
  setData(*near_, data);
}

void PositionalLayer::highlight(const std::vector<std::uint32_t>& cells) {
  std::vector<std::array<Vec3, 2>> lines;
  for (const std::uint32_t cell : cells) {
    if (cell >= quads_.size()) continue;
    for (std::size_t k = 0; k < 4; ++k) lines.push_back({quads_[cell][k], quads_[cell][(k + 1) % 4]});
  }
  setData(*highlighted_, lines.empty() ? nullptr : toSegments(lines).Get());
}

void PositionalLayer::setTheme(const Theme& theme) {
  setColour(*highlighted_, toRgb(theme.examined));
}

std::optional<PositionalLayer::Pick> PositionalLayer::pick(const SightLine& line) const {
  if (!caster_) return std::nullopt;
  double from = 0.0;
  // Through the veil to the far half: the one that the line leaves through.
  while (const auto hit = caster_->intersect(line.origin, line.direction, from)) {
    if (hit->normal.dot(line.direction) > 0.0) {
      const auto cell = static_cast<int>(hit->triangle / 2);
      return Pick{cell / columns_, cell % columns_};
    }
    from = hit->distance + 1e-3 * reach_;
  }
  return std::nullopt;
}

}  // namespace vantage
