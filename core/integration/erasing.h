#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/region_probe.h"
#include "integration/model.h"
#include "scanner/view.h"

namespace vantage {

/// Where in every stand of the object there is something that is not the object. Cheap to copy.
class ErasedSpace {
 public:
  /// Adds a region in the frame of the table of a stand. What is erased in one stand says nothing of another: a holder
  /// does not move with an object that is turned over.
  void add(int stand, std::shared_ptr<const RegionProbe> region, const Pose& T_object_table);

  [[nodiscard]] bool empty() const { return regions_.empty(); }
  [[nodiscard]] bool isIn(int stand) const;
  /// Whether a point in object coordinates, as it was seen in a stand, lies there or no farther than `margin` away
  /// [mm].
  [[nodiscard]] bool holds(int stand, const Vec3& p, double margin = 0.0) const;

  /// A region of one stand.
  struct Placed {
    int stand = 0;
    std::shared_ptr<const RegionProbe> region;  ///< in the frame of the stand's table
    Pose T_table_object;
    bool moved = false;  ///< else the frames are the same
  };
  [[nodiscard]] const std::vector<Placed>& regions() const { return regions_; }

 private:
  std::vector<Placed> regions_;
};

/// 1 for the triangles of a model that have a vertex in the erased space of the stand that its sample was taken in.
/// @param views by the model's provenance @throws InvalidInput when the provenance names no view; Cancelled
[[nodiscard]] std::vector<std::uint8_t> erasedTriangles(const Model& model, std::span<const View> views,
                                                        const ErasedSpace& space, const Progress& progress = {});

/// The model without what is erased. All else stays as it is, to the last bit and in its order, but for single
/// triangles that would touch the rest in one vertex only: the model stays manifold.
/// @throws as erasedTriangles
[[nodiscard]] Model withoutErased(const Model& model, std::span<const View> views, const ErasedSpace& space,
                                  const Progress& progress = {});

/// A view whose mesh lacks what is erased: the triangles of erased samples. Its image stays whole: where the erased
/// thing was, no ray looked through. The same pieces where nothing is erased.
[[nodiscard]] View withoutErased(const View& view, const ErasedSpace& space);

/// What views of one stand saw that is not the object: their triangles in the erased space, in object coordinates. It
/// is there all the same: it hides, and scans can be registered with it.
/// @param confidence when not null: one per vertex
[[nodiscard]] Mesh erasedSurface(std::span<const View> views, int stand, const ErasedSpace& space,
                                 std::vector<float>* confidence = nullptr);

/// 1 for the vertices of a model's border beyond which lies what is erased in a stand: no scan that is taken in this
/// stand shows more of the object there.
/// @param views by the model's provenance @throws InvalidInput when the provenance names no view
[[nodiscard]] std::vector<std::uint8_t> erasedBorder(const Model& model, std::span<const View> views, int stand,
                                                     const ErasedSpace& space);

}  // namespace vantage
