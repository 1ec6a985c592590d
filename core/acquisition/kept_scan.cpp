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
      break;
  }
  return "waiting";
}

KeptScan keepAsView(const NumberedScan& scan, const ScanCut& cut, const TriangulationOptions& triangulation) {
  CutImage image = cutImage(scan.image, cut);
  KeptScan kept;
  kept.number = scan.number;
  kept.view.image = std::move(image.image);
  kept.view.mesh = std::make_shared<const ViewMesh>(triangulate(*kept.view.image, triangulation));
  kept.view.T_object_scanner = kept.view.image->T_table_scanner;
  kept.record.cut = image.counts;
  kept.record.samples = kept.view.image->sampleCount();
  kept.record.triangles = kept.view.mesh->mesh.triangles.size();
  return kept;
}

}  // namespace vantage
