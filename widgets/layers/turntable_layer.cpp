#include "layers/turntable_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkVectorText.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr int kSegments = 180;
constexpr double kCircleStep = 50.0;   // [mm]
constexpr int kLabelStep = 30;         // [degrees]
constexpr int kTickStep = 10;          // [degrees]
constexpr double kTextHeight = 0.085;  // of the radius
constexpr double kRim = 1.22;          // of the radius: the disc ends beyond the labels
constexpr double kLinesAt = 0.2;       // lines and labels lie above it [mm]
constexpr double kLabelsAt = 0.5;
constexpr double kBelow = 0.4;  // the disc lies below what stands on it [mm]

using Segment = std::array<Vec3, 2>;

Vec3 onCircle(double radius, double azimuth, double z) {
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

Mesh disc(double radius) {
  Mesh mesh;
  mesh.vertices.push_back({0.0, 0.0, -kBelow});
  for (int i = 0; i < kSegments; ++i) mesh.vertices.push_back(onCircle(radius, 2.0 * kPi * i / kSegments, -kBelow));
  for (std::uint32_t i = 0; i < kSegments; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSegments});
  return mesh;
}

void addCircle(std::vector<Segment>& lines, double radius) {
  for (int i = 0; i < kSegments; ++i)
    lines.push_back({onCircle(radius, 2.0 * kPi * i / kSegments, kLinesAt),
                     onCircle(radius, 2.0 * kPi * (i + 1) / kSegments, kLinesAt)});
}

// Circles of the scale within the rim, not upon it.
int circlesWithin(double radius) {
  return std::max(static_cast<int>(std::ceil((radius - 1.0) / kCircleStep)) - 1, 0);
}

std::vector<Segment> scaleLines(double radius) {
  std::vector<Segment> lines;
  for (int i = 1; i <= circlesWithin(radius); ++i) addCircle(lines, i * kCircleStep);
  addCircle(lines, radius);
  for (int degree = 0; degree < 360; degree += kTickStep) {
    const double length = degree % kLabelStep == 0 ? 0.05 : 0.025;
    lines.push_back(
        {onCircle(radius, radians(degree), kLinesAt), onCircle((1.0 + length) * radius, radians(degree), kLinesAt)});
  }
  return lines;
}

// Flat text about a place on the disc, its foot toward `down`.
void addText(Mesh& mesh, const std::string& text, const Vec3& place, const Vec3& down, double height) {
  const auto source = vtkSmartPointer<vtkVectorText>::New();
  source->SetText(text.c_str());
  source->Update();
  vtkPolyData& shape = *source->GetOutput();
  double bounds[6];
  shape.GetBounds(bounds);
  const Vec3 up = -down;
  const Vec3 right = up.cross(Vec3::UnitZ());
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const double middleX = 0.5 * (bounds[0] + bounds[1]);
  const double middleY = 0.5 * (bounds[2] + bounds[3]);
  for (vtkIdType i = 0; i < shape.GetNumberOfPoints(); ++i) {
    const double* p = shape.GetPoint(i);
    mesh.vertices.push_back(place + height * ((p[0] - middleX) * right + (p[1] - middleY) * up));
  }
  vtkIdType corners = 0;
  const vtkIdType* cell = nullptr;
  vtkCellArray& cells = *shape.GetPolys();
  for (cells.InitTraversal(); cells.GetNextCell(corners, cell) != 0;)
    mesh.triangles.push_back({first + static_cast<std::uint32_t>(cell[0]), first + static_cast<std::uint32_t>(cell[1]),
                              first + static_cast<std::uint32_t>(cell[2])});
}

Mesh labels(double radius) {
  Mesh mesh;
  const double height = kTextHeight * radius;
  for (int degree = 0; degree < 360; degree += kLabelStep) {
    const Vec3 inward = -onCircle(1.0, radians(degree), 0.0);
    // Read from outside, where the one who looks at the object stands.
    addText(mesh, std::to_string(degree), onCircle(1.13 * radius, radians(degree), kLabelsAt), -inward, height);
  }
  for (int i = 1; i <= circlesWithin(radius); ++i) {
    const double r = i * kCircleStep;
    addText(mesh, std::to_string(static_cast<int>(r)) + " mm", onCircle(r, radians(15.0), kLabelsAt),
            onCircle(1.0, radians(15.0), 0.0), 0.8 * height);
  }
  return mesh;
}

// An arrow on the rim that points at the axis.
Mesh arrow(double radius, double azimuth) {
  const Vec3 outward = onCircle(1.0, azimuth, 0.0);
  const Vec3 side = Vec3::UnitZ().cross(outward);
  const double length = 0.12 * radius;
  Mesh mesh;
  mesh.vertices = {1.01 * radius * outward, (1.01 * radius + length) * outward + 0.4 * length * side,
                   (1.01 * radius + length) * outward - 0.4 * length * side};
  for (Vec3& v : mesh.vertices) v.z() = 0.6;
  mesh.triangles = {{0, 2, 1}};
  return mesh;
}

void showArrow(vtkActor& actor, double radius, std::optional<double> azimuth) {
  setData(actor, azimuth && radius > 0.0 ? toPolyData(arrow(radius, *azimuth), false).Get() : nullptr);
}

}  // namespace

TurntableLayer::TurntableLayer(Scene& scene)
    : scene_(scene),
      disc_(makeActor()),
      lines_(makeActor()),
      labels_(makeActor()),
      current_(makeActor()),
      proposed_(makeActor()) {
  scene.add(*disc_);
  scene.addLines(*lines_, 1.0);
  for (vtkActor* actor : {labels_.Get(), current_.Get(), proposed_.Get()}) scene.add(*actor);
  for (vtkActor* actor : actors()) setUnlit(*actor);
  setInFront(*lines_, 2.0);
  setInFront(*labels_, 2.0);
  setInFront(*current_, 4.0);
  setInFront(*proposed_, 4.0);
  setTheme(lightTheme());
}

std::vector<vtkActor*> TurntableLayer::actors() const {
  return {disc_, lines_, labels_, current_, proposed_};
}

void TurntableLayer::set(const ScannerProfile* profile) {
  const double radius = profile != nullptr ? profile->viewingVolume.radius : 0.0;
  if (radius == radius_) return;
  radius_ = radius;
  scene_.change([this, radius] {
    for (vtkActor* actor : actors()) setData(*actor, nullptr);
    if (radius <= 0.0) return;
    setData(*disc_, toPolyData(disc(kRim * radius), false));
    setData(*lines_, toSegments(scaleLines(radius)));
    setData(*labels_, toPolyData(labels(radius), false));
  });
}

void TurntableLayer::mark(std::optional<double> current, std::optional<double> proposed) {
  scene_.change([this, radius = radius_, current, proposed] {
    showArrow(*current_, radius, current);
    showArrow(*proposed_, radius, proposed);
  });
}

void TurntableLayer::setVisible(bool visible) {
  scene_.change([this, visible] {
    for (vtkActor* actor : actors()) actor->SetVisibility(visible);
  });
}

void TurntableLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] {
    setColour(*disc_, toRgb(theme.table));
    setColour(*lines_, toRgb(theme.mutedText));
    setColour(*labels_, toRgb(theme.text));
    setColour(*current_, toRgb(theme.current));
    setColour(*proposed_, toRgb(theme.proposed));
  });
}

}  // namespace vantage
