#pragma once

#include <QImage>
#include <functional>
#include <span>

#include "geometry/ray_caster.h"
#include "look/theme.h"
#include "vtk/camera.h"

namespace vantage {

/// A surface in a picture.
struct PicturedSurface {
  const RayCaster* caster = nullptr;
  Pose T_scene_surface = Pose::Identity();
  std::function<Rgb(std::uint32_t triangle)> colour;  ///< on its front; its back is darker
};

/// A small picture of surfaces, drawn ray by ray without a graphics card, on any thread. The same input gives the same
/// bytes. @throws Cancelled
[[nodiscard]] QImage rayPicture(std::span<const PicturedSurface> surfaces, const Camera& camera, const QSize& size,
                                const Theme& theme, const Progress& progress = {});

}  // namespace vantage
