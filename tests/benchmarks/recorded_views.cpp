#include "recorded_views.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace vantage {
namespace {

// The head of a range file: a pinhole scanner that looks at a point 140 mm above the table's centre.
struct FileHead {
  int columns;
  int rows;
  double focalLength;  // [pixels]
  double distance;     // [mm]
  double elevation;    // [deg]
  double angle;        // [deg] of the turntable
};

Pose poseOf(const FileHead& head) {
  const Vec3 centre(0, 0, 140);
  const double a = radians(head.angle);
  const double e = radians(head.elevation);
  const Vec3 eye = centre + head.distance * Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  const Vec3 forward = (centre - eye).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  Pose pose = Pose::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() = eye;
  return pose;
}

}  // namespace

std::optional<std::string> recordedViewsFolder() {
  const char* folder = std::getenv("VANTAGE_PERF_DATA");
  if (folder == nullptr) return std::nullopt;
  return folder;
}

View readRecordedView(const std::string& path, double breakdownAngle) {
  std::ifstream in(path, std::ios::binary);
  FileHead head{};
  in.read(reinterpret_cast<char*>(&head), sizeof head);
  if (!in || head.columns < 2 || head.rows < 2) throw std::runtime_error("cannot read " + path);
  const std::size_t count = static_cast<std::size_t>(head.columns) * static_cast<std::size_t>(head.rows);
  std::vector<float> depth(count);
  in.read(reinterpret_cast<char*>(depth.data()), static_cast<std::streamsize>(count * sizeof(float)));
  if (!in) throw std::runtime_error("cannot read " + path);

  auto image = std::make_shared<RangeImage>();
  image->T_table_scanner = poseOf(head);
  std::vector<RangingRay> rays;
  for (int r = 0; r < head.rows; ++r) {
    for (int c = 0; c < head.columns; ++c) {
      const Vec3 d((c + 0.5 - head.columns / 2.0) / head.focalLength, (r + 0.5 - head.rows / 2.0) / head.focalLength,
                   1);
      rays.push_back({Vec3::Zero(), d.normalized()});
      const float z = depth[rays.size() - 1];
      image->range.push_back(z > 0.0F ? static_cast<float>(z * d.norm()) : kNoSample);
    }
  }
  image->rays = std::make_shared<RayGrid>(head.rows, head.columns, std::move(rays), std::vector<Vec3>(), 0);
  TriangulationOptions options;
  options.breakdownAngle = breakdownAngle;
  View view;
  view.mesh = std::make_shared<const ViewMesh>(triangulate(*image, options));
  view.T_object_scanner = image->T_table_scanner;
  view.image = std::move(image);
  return view;
}

}  // namespace vantage
