#include "acquisition/kept_scan.h"

#include <utility>

namespace vantage {

std::string_view name(ScanStatus status) {
  switch (status) {
    case ScanStatus::In:
      return "in";
    case ScanStatus::Rejected:
      return "rejected";
    case ScanStatus::LeftOut:
      return "left_out";
    case ScanStatus::Waiting:
      return "waiting";
    case ScanStatus::Aside:
      break;
  }
  return "aside";
}

std::shared_ptr<const RayGrid> raysOfLast(const std::vector<KeptScan>& scans) {
  return scans.empty() ? nullptr : scans.back().view.image->rays;
}

KeptScan keepAsView(const NumberedScan& scan, const ScanUse& use, const TriangulationOptions& triangulation,
                    const std::shared_ptr<const RayGrid>& like, const Progress& progress) {
  UsedImage used = usedImage(scan.image, use, like, progress.part(0.0, 0.5));
  KeptScan kept;
  kept.number = scan.number;
  kept.view.image = std::move(used.image);
  kept.view.mesh =
      std::make_shared<const ViewMesh>(triangulate(*kept.view.image, triangulation, progress.part(0.5, 1.0)));
  kept.view.T_object_scanner = kept.view.image->T_table_scanner;
  kept.record.cut = used.cut;
  kept.record.samples = used.samples;
  kept.record.everyNth = used.everyNth;
  kept.record.triangles = kept.view.mesh->mesh.triangles.size();
  return kept;
}

}  // namespace vantage
