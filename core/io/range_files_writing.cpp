#include <cstring>

#include "base/atomic_file.h"
#include "io/range_files.h"

namespace vantage {
namespace {

// Whether reconstructRays() would find rays like these: all look down, and begin at the same height.
bool lookAlongZ(const RayGrid& rays) {
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (rays.ray(i).direction.z() > -0.5 || rays.ray(i).origin.z() != rays.ray(0).origin.z()) return false;
  return true;
}

std::string headerOf(const RangeImage& image) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += "obj_info num_cols " + std::to_string(image.rays->columns()) + "\n";
  text += "obj_info num_rows " + std::to_string(image.rays->rows()) + "\n";
  text += "obj_info unit_mm 1\n";
  text += std::string("obj_info rays ") + (lookAlongZ(*image.rays) ? "along_z" : "profile") + "\n";
  text += "element vertex " + std::to_string(image.sampleCount()) + "\n";
  text += "property float x\nproperty float y\nproperty float z\n";
  if (!image.colours.empty()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "element range_grid " + std::to_string(image.rays->size()) + "\n";
  text += "property list uchar int vertex_indices\n";
  return text + "end_header\n";
}

}  // namespace

void writeRangeFile(const RangeImage& image, const std::string& path, const Progress& progress) {
  validate(image);
  AtomicFile file(path);
  file.write(headerOf(image));
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    if (!image.valid(i)) continue;
    const Eigen::Vector3f p = image.point(i).cast<float>();
    std::memcpy(file.grow(sizeof(p)), p.data(), sizeof(p));
    if (!image.colours.empty()) std::memcpy(file.grow(sizeof(Colour)), image.colours[i].data(), sizeof(Colour));
  }
  progress.checkpoint(0.5);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    const bool valid = image.valid(i);
    char* at = file.grow(valid ? 1 + sizeof(next) : 1);
    *at = valid ? 1 : 0;
    if (valid) std::memcpy(at + 1, &next, sizeof(next));
    next += valid ? 1 : 0;
  }
  file.commit();
  progress.checkpoint(1.0);
}

}  // namespace vantage
