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

// Corners are counter-clockwise seen from outside.
bool leaves(const std::array<Vec3, 4>& quad, const SightLine& line) {
  return (quad[2] - quad[0]).cross(quad[3] - quad[1]).dot(line.direction) > 0.0;
}

std::vector<Rgb> coloursOf(const CellField& field) {
  std::vector<Rgb> colours;
  colours.reserve(field.values.size());
  for (const double value : field.values)
    colours.push_back(colourAt(field.map, field.maximum > 0.0 ? value / field.maximum : 0.0));
  return colours;
}

}  // namespace

PositionalLayer::PositionalLayer(Scene& scene)
    : scene_(scene), far_(makeActor()), near_(makeActor()), highlighted_(makeActor()) {
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
  columns_ = 0;
  if (grid != nullptr) {
    for (const SurfaceCell& cell : grid->surfaceCells()) quads_.push_back(cornersOf(cell));
    columns_ = grid->columns();
  }
  vtkSmartPointer<vtkPolyData> data;
  if (field != nullptr && !quads_.empty()) data = withCellColours(*toQuads(quads_), coloursOf(*field));
  scene_.change([this, data] {
    setData(*far_, data);
    setData(*near_, data);
  });
}

void PositionalLayer::highlight(const std::vector<std::uint32_t>& cells) {
  std::vector<std::array<Vec3, 2>> lines;
  for (const std::uint32_t cell : cells) {
    if (cell >= quads_.size()) continue;
    for (std::size_t k = 0; k < 4; ++k) lines.push_back({quads_[cell][k], quads_[cell][(k + 1) % 4]});
  }
  scene_.change(
      [this, lines = std::move(lines)] { setData(*highlighted_, lines.empty() ? nullptr : toSegments(lines).Get()); });
}

void PositionalLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] { setColour(*highlighted_, toRgb(theme.examined)); });
}

std::optional<MapCell> PositionalLayer::pick(const SightLine& line) const {
  std::optional<MapCell> far;
  double farthest = 0.0;
  // The surface is met twice, first in the half toward the eye: the far half is where the line leaves.
  for (std::size_t cell = 0; cell < quads_.size(); ++cell) {
    const auto distance = distanceTo(quads_[cell], line);
    if (!distance || *distance < farthest || !leaves(quads_[cell], line)) continue;
    farthest = *distance;
    far = MapCell{static_cast<int>(cell) / columns_, static_cast<int>(cell) % columns_};
  }
  return far;
}

}  // namespace vantage
