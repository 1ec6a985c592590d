#include "layers/measure_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr double kMeasureWidth = 2.0;
// The line is seen through what it passes behind: it is a straight line, not one on the surface.
constexpr double kMeasureInFront = 15000.0;

}  // namespace

MeasureLayer::MeasureLayer(Scene& scene) : scene_(scene), line_(makeActor()), markers_(scene) {
  scene.addLines(*line_, kMeasureWidth);
  setUnlit(*line_);
  setInFront(*line_, kMeasureInFront);
  setTheme(lightTheme());
}

void MeasureLayer::set(const std::vector<Vec3>& places, double size) {
  markers_.set(places, size);
  std::vector<std::array<Vec3, 2>> lines;
  if (places.size() == 2) lines.push_back({places[0], places[1]});
  scene_.change(
      [this, lines = std::move(lines)] { setData(*line_, lines.empty() ? nullptr : toSegments(lines).Get()); });
}

void MeasureLayer::setTheme(const Theme& theme) {
  markers_.setTheme(theme);
  scene_.change([this, &theme] { setColour(*line_, toRgb(theme.examined)); });
}

}  // namespace vantage
