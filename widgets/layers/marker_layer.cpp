#include "layers/marker_layer.h"

#include <vtkActor.h>
#include <vtkFollower.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVectorText.h>

#include <algorithm>
#include <string>

#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr int kRings = 10;
// A number is so much higher than its ball.
constexpr double kNumberSize = 2.6;
// Numbers are drawn before what they stand on.
constexpr double kInFront = 20000.0;

void addBall(Mesh& mesh, const Vec3& centre, double radius) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  constexpr int kColumns = 2 * kRings;
  for (int r = 0; r <= kRings; ++r) {
    const double polar = kPi * r / kRings;
    for (int c = 0; c < kColumns; ++c) {
      const double azimuth = 2.0 * kPi * c / kColumns;
      mesh.vertices.push_back(centre + radius * Vec3(std::sin(polar) * std::cos(azimuth),
                                                     std::sin(polar) * std::sin(azimuth), std::cos(polar)));
    }
  }
  for (std::uint32_t r = 0; r < kRings; ++r)
    for (std::uint32_t c = 0; c < kColumns; ++c) {
      const std::uint32_t next = (c + 1) % kColumns;
      const std::uint32_t above = first + r * kColumns;
      const std::uint32_t below = above + kColumns;
      mesh.triangles.push_back({above + c, below + c, below + next});
      mesh.triangles.push_back({above + c, below + next, above + next});
    }
}

}  // namespace

MarkerLayer::MarkerLayer(Scene& scene) : scene_(scene), balls_(makeActor()) {
  scene.add(*balls_);
  setUnlit(*balls_);
  setInFront(*balls_, 0.5 * kInFront);
  for (std::size_t i = 0; i < kMost; ++i) {
    const auto text = vtkSmartPointer<vtkVectorText>::New();
    text->SetText(std::to_string(i + 1).c_str());
    const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(text->GetOutputPort());
    auto number = vtkSmartPointer<vtkFollower>::New();
    number->SetMapper(mapper);
    number->SetCamera(scene.renderer().GetActiveCamera());
    number->SetVisibility(false);
    setUnlit(*number);
    setInFront(*number, kInFront);
    scene.add(*number);
    numbers_.push_back(std::move(number));
  }
  setTheme(lightTheme());
}

void MarkerLayer::set(const std::vector<Vec3>& places, double size) {
  const std::vector<Vec3> shown(places.begin(),
                                places.begin() + static_cast<std::ptrdiff_t>(std::min(places.size(), kMost)));
  scene_.change([this, shown, size] {
    Mesh balls;
    for (const Vec3& p : shown) addBall(balls, p, size);
    setData(*balls_, shown.empty() ? nullptr : toPolyData(balls, true).Get());
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      numbers_[i]->SetVisibility(i < shown.size());
      if (i >= shown.size()) continue;
      // The text begins at its lower left: beside the ball.
      numbers_[i]->SetOrigin(-0.6, -0.4, 0.0);
      numbers_[i]->SetPosition(shown[i].x() + 0.6, shown[i].y() + 0.4, shown[i].z());
      numbers_[i]->SetScale(kNumberSize * size);
    }
  });
}

void MarkerLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] {
    setColour(*balls_, toRgb(theme.examined));
    for (const auto& number : numbers_) setColour(*number, toRgb(theme.text));
  });
}

}  // namespace vantage
