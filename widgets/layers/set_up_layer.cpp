#include "layers/set_up_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <array>
#include <cmath>
#include <vector>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr int kSides = 72;
constexpr int kUprights = 12;
constexpr double kLineWidth = 1.0;
constexpr double kGlass = 0.55;

using Segment = std::array<Vec3, 2>;

std::vector<Segment> outlineOf(const ViewingVolume& volume) {
  const auto at = [&](int side, double z) {
    const double azimuth = 2.0 * kPi * side / kSides;
    return Vec3(volume.radius * std::cos(azimuth), volume.radius * std::sin(azimuth), z);
  };
  std::vector<Segment> lines;
  for (int side = 0; side < kSides; ++side) {
    for (const double z : {0.0, volume.height}) lines.push_back({at(side, z), at(side + 1, z)});
    if (side % (kSides / kUprights) == 0) lines.push_back({at(side, 0.0), at(side, volume.height)});
  }
  return lines;
}

}  // namespace

SetUpLayer::SetUpLayer(Scene& scene) : scene_(scene), volume_(makeActor()), object_(makeActor()) {
  scene.addLines(*volume_, kLineWidth);
  scene.add(*object_);
  setUnlit(*volume_);
  object_->GetProperty()->SetOpacity(kGlass);
  setTheme(lightTheme());
}

void SetUpLayer::set(const ScannerProfile* profile, const std::shared_ptr<const Mesh>& object) {
  scene_.change(
      [this, lines = profile != nullptr ? outlineOf(profile->viewingVolume) : std::vector<Segment>(), object] {
        setData(*volume_, lines.empty() ? nullptr : toSegments(lines).Get());
        setData(*object_, object ? toPolyData(*object, true).Get() : nullptr);
      });
}

void SetUpLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] {
    setColour(*volume_, toRgb(theme.mutedText));
    setColour(*object_, toRgb(theme.surface));
  });
}

}  // namespace vantage
