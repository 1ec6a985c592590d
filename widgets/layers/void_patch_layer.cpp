#include "layers/void_patch_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "planning/scanner_picture.h"
#include "vtk/poly_data.h"

namespace vantage {
namespace {

constexpr double kHighlightWidth = 2.5;
constexpr double kHighlightInFront = 12.0;
constexpr double kPatchesInFront = 2.0;

std::vector<std::array<Vec3, 4>> corners(const std::vector<VoidPatch>& patches) {
  std::vector<std::array<Vec3, 4>> quads;
  quads.reserve(patches.size());
  for (const VoidPatch& patch : patches) quads.push_back(patch.corners);
  return quads;
}

}  // namespace

VoidPatchLayer::VoidPatchLayer(Scene& scene) : patches_(makeActor()), highlighted_(makeActor()) {
  scene.add(*patches_);
  scene.addLines(*highlighted_, kHighlightWidth);
  setInFront(*patches_, kPatchesInFront);
  setInFront(*highlighted_, kHighlightInFront);
  setUnlit(*highlighted_);
  // A patch is a class or a state, not a shape: light takes only a little of its colour.
  patches_->GetProperty()->SetAmbient(0.6);
  patches_->GetProperty()->SetDiffuse(0.4);
  setTheme(lightTheme());
}

void VoidPatchLayer::set(std::shared_ptr<const Plan> plan, VoidColouring colouring) {
  if (plan != plan_) {
    caster_.reset();
    if (plan && plan->voids) caster_.emplace(patchMesh(*plan->voids));
    setData(*highlighted_, nullptr);
  }
  plan_ = std::move(plan);
  colouring_ = colouring;
  colour();
}

void VoidPatchLayer::colour() {
  if (!plan_ || !plan_->voids) return setData(*patches_, nullptr);
  const std::vector<VoidPatch>& patches = plan_->voids->patches;
  std::vector<Rgb> colours;
  colours.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const bool byState = colouring_ == VoidColouring::State && p < plan_->outlook.size();
    colours.push_back(byState ? patchStateColour(patchState(plan_->outlook[p], plan_->outcome))
                              : edgeClassColour(patches[p].edgeClass));
  }
  setData(*patches_, withCellColours(*toQuads(corners(patches)), colours));
}

void VoidPatchLayer::setVisible(bool visible) {
  patches_->SetVisibility(visible);
  highlighted_->SetVisibility(visible);
}

void VoidPatchLayer::setTheme(const Theme& theme) {
  setColour(*highlighted_, toRgb(theme.examined));
}

void VoidPatchLayer::highlight(const std::vector<std::uint32_t>& patches) {
  std::vector<std::array<Vec3, 2>> lines;
  if (plan_ && plan_->voids) {
    for (const std::uint32_t p : patches) {
      if (p >= plan_->voids->patches.size()) continue;
      const auto& c = plan_->voids->patches[p].corners;
      for (std::size_t k = 0; k < 4; ++k) lines.push_back({c[k], c[(k + 1) % 4]});
    }
  }
  setData(*highlighted_, lines.empty() ? nullptr : toSegments(lines).Get());
}

std::optional<VoidPatchLayer::Pick> VoidPatchLayer::pick(const SightLine& line) const {
  if (!caster_ || patches_->GetVisibility() == 0) return std::nullopt;
  const auto hit = caster_->intersect(line.origin, line.direction);
  if (!hit) return std::nullopt;
  return Pick{hit->triangle / 2, hit->distance};
}

}  // namespace vantage
