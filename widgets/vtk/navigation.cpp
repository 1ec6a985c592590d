#include "vtk/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace vantage {
namespace {

struct Binding {
  Qt::MouseButton button;
  Qt::KeyboardModifiers modifiers;
  Motion motion;
};

constexpr std::array kMeshLab{
    Binding{Qt::LeftButton, Qt::NoModifier, Motion::Trackball},
    Binding{Qt::LeftButton, Qt::ControlModifier, Motion::Pan}, Binding{Qt::LeftButton, Qt::ShiftModifier, Motion::Zoom},
    Binding{Qt::MiddleButton, Qt::NoModifier, Motion::Pan}, Binding{Qt::RightButton, Qt::NoModifier, Motion::Roll}};
constexpr std::array kUpright{
    Binding{Qt::LeftButton, Qt::NoModifier, Motion::Turntable},
    Binding{Qt::LeftButton, Qt::ControlModifier, Motion::Pan}, Binding{Qt::LeftButton, Qt::ShiftModifier, Motion::Zoom},
    Binding{Qt::MiddleButton, Qt::NoModifier, Motion::Pan}, Binding{Qt::RightButton, Qt::NoModifier, Motion::Pan}};
constexpr std::array kCloudCompare{Binding{Qt::LeftButton, Qt::NoModifier, Motion::Trackball},
                                   Binding{Qt::RightButton, Qt::NoModifier, Motion::Pan},
                                   Binding{Qt::MiddleButton, Qt::NoModifier, Motion::Zoom}};
constexpr std::array kBlender{Binding{Qt::MiddleButton, Qt::NoModifier, Motion::Turntable},
                              Binding{Qt::MiddleButton, Qt::ShiftModifier, Motion::Pan},
                              Binding{Qt::MiddleButton, Qt::ControlModifier, Motion::Zoom}};
constexpr std::array kParaView{Binding{Qt::LeftButton, Qt::NoModifier, Motion::Trackball},
                               Binding{Qt::LeftButton, Qt::ShiftModifier, Motion::Roll},
                               Binding{Qt::LeftButton, Qt::ControlModifier, Motion::Zoom},
                               Binding{Qt::MiddleButton, Qt::NoModifier, Motion::Pan},
                               Binding{Qt::RightButton, Qt::ShiftModifier, Motion::Pan},
                               Binding{Qt::RightButton, Qt::NoModifier, Motion::Zoom}};

// Half a turn for a drag over the height of the picture; twice as near for a quarter of it.
constexpr double kTurn = kPi;
constexpr double kZoom = 4.0;
constexpr double kWheelStep = 1.15;
constexpr double kNearest = 1.0;   // [mm]
constexpr double kFarthest = 1e6;  // [mm]
// The turntable stops short of looking straight along z, where up would be undefined.
constexpr double kPole = radians(1.0);

std::span<const Binding> bindings(NavigationScheme scheme) {
  switch (scheme) {
    case NavigationScheme::Upright:
      return kUpright;
    case NavigationScheme::CloudCompare:
      return kCloudCompare;
    case NavigationScheme::Blender:
      return kBlender;
    case NavigationScheme::ParaView:
      return kParaView;
    case NavigationScheme::MeshLab:
      break;
  }
  return kMeshLab;
}

Camera rotated(const Camera& camera, const Eigen::AngleAxisd& rotation) {
  Camera result = camera;
  result.eye = camera.target + rotation * (camera.eye - camera.target);
  result.up = (rotation * camera.up).normalized();
  return result;
}

Camera turnedByTable(const Camera& camera, double aboutZ, double tilt) {
  const Camera turnedAboutZ = rotated(camera, Eigen::AngleAxisd(aboutZ, Vec3::UnitZ()));
  Vec3 right = turnedAboutZ.forward().cross(Vec3::UnitZ());
  right = right.norm() < 1e-6 ? turnedAboutZ.right() : Vec3(right.normalized());
  const double elevation = std::asin(std::clamp(-turnedAboutZ.forward().z(), -1.0, 1.0));
  const double wanted = std::clamp(elevation - tilt, -0.5 * kPi + kPole, 0.5 * kPi - kPole);
  Camera result = rotated(turnedAboutZ, Eigen::AngleAxisd(elevation - wanted, right));
  result.up = right.cross(result.forward()).normalized();
  return result;
}

Camera atDistance(const Camera& camera, double factor) {
  Camera result = camera;
  const double distance = std::clamp(camera.distance() * factor, kNearest, kFarthest);
  result.eye = camera.target - distance * camera.forward();
  return result;
}

}  // namespace

Motion motionFor(NavigationScheme scheme, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  for (const Binding& binding : bindings(scheme))
    if (binding.button == button && binding.modifiers == modifiers) return binding.motion;
  return Motion::None;
}

Camera moved(const Camera& camera, Motion motion, const QPointF& from, const QPointF& to, const QSizeF& size) {
  const QPointF drag = (to - from) / std::max(1.0, size.height());
  const Vec3 right = camera.right();
  const Vec3 up = right.cross(camera.forward());
  switch (motion) {
    case Motion::Trackball: {
      const Vec3 axis = -drag.y() * right - drag.x() * up;
      if (axis.norm() == 0.0) return camera;
      return rotated(camera, Eigen::AngleAxisd(axis.norm() * kTurn, axis.normalized()));
    }
    case Motion::Turntable:
      return turnedByTable(camera, -drag.x() * kTurn, -drag.y() * kTurn);
    case Motion::Pan: {
      const double height = 2.0 * camera.distance() * std::tan(0.5 * camera.viewAngle);
      const Vec3 shift = height * (-drag.x() * right + drag.y() * up);
      Camera result = camera;
      result.eye += shift;
      result.target += shift;
      return result;
    }
    case Motion::Zoom:
      return atDistance(camera, std::pow(2.0, kZoom * drag.y()));
    case Motion::Roll:
      return rotated(camera, Eigen::AngleAxisd(drag.x() * kTurn, camera.forward()));
    case Motion::None:
      break;
  }
  return camera;
}

Camera zoomed(const Camera& camera, double steps) {
  return atDistance(camera, std::pow(kWheelStep, -steps));
}

}  // namespace vantage
