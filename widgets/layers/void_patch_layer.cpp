#include "layers/void_patch_layer.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

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

vtkSmartPointer<vtkPolyData> colouredPatches(const Plan& plan, VoidColouring colouring) {
  const std::vector<VoidPatch>& patches = plan.voids->patches;
  std::vector<Rgb> colours;
  colours.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const bool byState = colouring == VoidColouring::State && p < plan.outlook.size();
    colours.push_back(byState ? patchStateColour(patchState(plan.outlook[p], plan.outcome))
                              : edgeClassColour(patches[p].edgeClass));
  }
  return withCellColours(*toQuads(corners(patches)), colours);
}

}  // namespace

VoidPatchLayer::VoidPatchLayer(Scene& scene) : scene_(scene), patches_(makeActor()), highlighted_(makeActor()) {
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
  if (plan == plan_ && colouring == colouring_) return;
  if (plan != plan_) highlight({});
  plan_ = std::move(plan);
  colouring_ = colouring;
  scene_.change([this, colouring, shown = plan_] {
    setData(*patches_, shown && shown->voids ? colouredPatches(*shown, colouring).Get() : nullptr);
  });
}

void VoidPatchLayer::setVisible(bool visible) {
  visible_ = visible;
  scene_.change([this, visible] {
    patches_->SetVisibility(visible);
    highlighted_->SetVisibility(visible);
  });
}

void VoidPatchLayer::setSection(const std::optional<Section>& section) {
  section_ = section;
  scene_.change([this, section] {
    for (vtkActor* actor : {patches_.Get(), highlighted_.Get()})
      setClip(*actor, section ? std::optional(section->plane()) : std::nullopt);
  });
}

void VoidPatchLayer::setTheme(const Theme& theme) {
  scene_.change([this, &theme] { setColour(*highlighted_, toRgb(theme.examined)); });
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
  scene_.change(
      [this, lines = std::move(lines)] { setData(*highlighted_, lines.empty() ? nullptr : toSegments(lines).Get()); });
}

// One after the other: that is quicker than a search tree would be made after every scan.
std::optional<VoidPatchLayer::Pick> VoidPatchLayer::pick(const SightLine& line) const {
  std::optional<Pick> nearest;
  if (!plan_ || !plan_->voids || !visible_) return nearest;
  const std::vector<VoidPatch>& patches = plan_->voids->patches;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto distance = distanceTo(patches[p].corners, line);
    if (distance && section_ && section_->hides(line.origin + *distance * line.direction)) continue;
    if (distance && (!nearest || *distance < nearest->distance))
      nearest = Pick{static_cast<std::uint32_t>(p), *distance};
  }
  return nearest;
}

}  // namespace vantage
