// Time to the first picture and frame time against the size of the model, beside VTK drawing the same mesh in a bare
// window of its own in the same run. Everything is drawn by OSMesa.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "osmesa/osmesa_window.h"
#include "scenes/model_scene.h"
#include "support/meshes.h"
#include "vtk/navigation.h"

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr QSize kSize(1280, 800);
constexpr int kFrames = 24;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Resident memory of this program [MB].
double residentMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

// A bumpy ball of about that many triangles.
std::shared_ptr<const Model> ball(std::size_t triangles) {
  auto model = std::make_shared<Model>();
  const int rings = static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4.0));
  model->mesh = testing::makeSphere(80.0, rings, {0.0, 0.0, 90.0});
  for (Vec3& v : model->mesh.vertices) {
    const Vec3 d = (v - Vec3(0.0, 0.0, 90.0)).normalized();
    v += 3.0 * std::sin(9.0 * d.x()) * std::sin(11.0 * d.y()) * std::cos(7.0 * d.z()) * d;
  }
  model->confidence.assign(model->mesh.vertices.size(), 0.8F);
  model->vertexView.assign(model->mesh.vertices.size(), 0);
  model->vertexSample.assign(model->mesh.vertices.size(), 0);
  model->triangleView.assign(model->mesh.triangles.size(), 0);
  return model;
}

struct Times {
  double first = 0.0;  // [s] from the mesh to its first picture
  double frame = 0.0;  // [s] of one picture while the camera turns
};

// Pictures of a scene on a turn. @return seconds per picture
double turn(Scene& scene, OffscreenWindow& window) {
  const auto start = Clock::now();
  for (int i = 0; i < kFrames; ++i) {
    scene.setCamera(moved(scene.camera(), Motion::Turntable, {0.0, 0.0}, {20.0, 3.0}, kSize));
    (void)window.render(scene, scene.camera(), kSize, 1.0);
  }
  return secondsSince(start) / kFrames;
}

Camera startCamera(const BoundingBox& box) {
  return cameraToward({-1.0, 0.5, -0.5}, box, static_cast<double>(kSize.width()) / kSize.height());
}

// One renderer, one actor, nothing else of ours but the conversion to vtkPolyData.
Times bareWindow(const Model& model) {
  Times times;
  const auto start = Clock::now();
  const auto window = osmesaWindows()();
  Scene scene;
  const auto actor = makeActor();
  setData(*actor, toPolyData(model.mesh, true));
  scene.renderer().SetUseFXAA(false);
  scene.add(*actor);
  scene.setCamera(startCamera(boundingBox(model.mesh)));
  (void)window->render(scene, scene.camera(), kSize, 1.0);
  times.first = secondsSince(start);
  times.frame = turn(scene, *window);
  return times;
}

void run(std::size_t triangles) {
  const auto model = ball(triangles);
  const Times bare = bareWindow(*model);
  const double before = residentMegabytes();

  auto start = Clock::now();
  const auto window = osmesaWindows()();
  ModelScene scene;
  auto state = std::make_shared<AcquisitionState>();
  state->model = model;
  const auto snapshot = makeSnapshot(state);
  // As the views do: a large model is shown before it can be picked.
  auto geometry = needsStandIn(*model) ? prepareSurface(model) : prepareModelGeometry(model);
  scene.set(snapshot, geometry);
  scene.scene().setCamera(startCamera(geometry->box));
  (void)window->render(scene.scene(), scene.scene().camera(), kSize, 1.0);
  const double first = secondsSince(start);
  const double still = turn(scene.scene(), *window);

  start = Clock::now();
  geometry = withStandIn(geometry->caster ? geometry : withPicking(geometry));
  const double complete = secondsSince(start);
  scene.set(snapshot, geometry);
  scene.setMoving(true);
  (void)window->render(scene.scene(), scene.scene().camera(), kSize, 1.0);
  const double moving = turn(scene.scene(), *window);
  std::printf("%9zu %8.2f %8.2f %6.2f %9.1f %9.1f %9.1f %7.1f %9.2f %8.0f\n", model->mesh.triangles.size(), bare.first,
              first, first / bare.first, 1e3 * bare.frame, 1e3 * still, 1e3 * moving, 1.0 / moving, complete,
              residentMegabytes() - before);
}

}  // namespace
}  // namespace vantage

int main() {
  std::printf(
      "%d x %d pixels; bare: VTK alone; first: to the first picture; frames while the camera turns; then: "
      "until it can be picked and has its stand-in\n",
      vantage::kSize.width(), vantage::kSize.height());
  std::printf("%9s %8s %8s %6s %9s %9s %9s %7s %9s %8s\n", "triangles", "bare s", "first s", "ratio", "bare ms",
              "still ms", "moving ms", "fps", "then s", "MB");
  for (const std::size_t triangles : {20000UL, 200000UL, 1100000UL}) vantage::run(triangles);
  return 0;
}
