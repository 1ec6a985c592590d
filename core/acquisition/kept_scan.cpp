#include "acquisition/kept_scan.h"

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

KeptScan keepAsView(const NumberedScan& scan, const TriangulationOptions& options) {
  KeptScan kept;
  kept.number = scan.number;
  kept.view.image = scan.image;
  kept.view.mesh = std::make_shared<const ViewMesh>(triangulate(*scan.image, options));
  kept.view.T_object_scanner = scan.image->T_table_scanner;
  kept.record.samples = scan.image->sampleCount();
  kept.record.triangles = kept.view.mesh->mesh.triangles.size();
  return kept;
}

}  // namespace vantage
