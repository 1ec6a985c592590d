#pragma once

#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/grid_scene.h"
#include "scanner/profile.h"
#include "scanner/ray_patterns.h"

namespace vantage::testing {

/// A rotating stripe of 40 x 48 rays about 2.5 mm apart before the lump.
inline ScannerProfile stripeProfile() {
  ScannerProfile profile;
  profile.rays = std::make_shared<const RayGrid>(makeRays(RotatingStripe{{300, 0, 5}, 100.0, 40, 48, 0.4}, {}));
  profile.minRange = 100.0;
  profile.maxRange = 500.0;
  profile.workspace.poses = {Pose::Identity(), Pose(Eigen::AngleAxisd(1.0, Vec3::UnitZ()))};
  return profile;
}

/// A pinhole of 40 x 44 rays.
inline ScannerProfile cameraProfile(int finer = 1) {
  ScannerProfile profile = stripeProfile();
  profile.rays = std::make_shared<const RayGrid>(
      makeRays(Pinhole{{300, 0, 40}, {0, 0, 0}, 40 * finer, 44 * finer, 0.24, 0.24}, {}));
  return profile;
}

/// The lump as the rays of a profile meet it, with a colour for every sample that tells its cell.
struct WrittenScan {
  const ScannerProfile& profile;
  std::vector<std::optional<Vec3>> points;
  std::vector<float> range;

  explicit WrittenScan(const ScannerProfile& of) : profile(of) {
    for (std::size_t i = 0; i < of.rays->size(); ++i) {
      const RangingRay& ray = of.rays->ray(i);
      const auto t = distanceToLump(ray);
      points.push_back(t ? std::optional(Vec3(ray.origin + *t * ray.direction)) : std::nullopt);
      range.push_back(t ? static_cast<float>(*t) : std::nanf(""));
    }
  }
  static Colour colourOf(std::size_t i) {
    return {static_cast<std::uint8_t>(10 + i % 200), static_cast<std::uint8_t>(i / 200 % 250), 77};
  }
  [[nodiscard]] int rows() const { return profile.rays->rows(); }
  [[nodiscard]] int columns() const { return profile.rays->columns(); }
};

/// How a vendor writes it.
struct Writing {
  Pose T_file_scanner = Pose::Identity();  ///< of points in millimetres
  double unit = 1.0;                       ///< units per millimetre
  bool colours = false;
  bool comma = false;
  std::string missing = "nan nan nan";
  bool fromTop = true;  ///< rows of the file; those of stripes begin below
};

/// Where the head of a pinhole or stripe looks: from a camera's frame to the profile's.
inline Pose cameraOf(const Vec3& position, const Vec3& forward, bool openGl = false) {
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  Pose pose = Pose::Identity();
  pose.linear().col(0) = right;
  pose.linear().col(1) = forward.cross(right) * (openGl ? -1.0 : 1.0);
  pose.linear().col(2) = forward * (openGl ? -1.0 : 1.0);
  pose.translation() = position;
  return pose;
}

inline std::string pointText(const WrittenScan& scan, const Writing& how, std::size_t i) {
  if (!scan.points[i]) return how.missing;
  const Vec3 p = how.unit * (how.T_file_scanner * *scan.points[i]);
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%.7f %.7f %.7f", p.x(), p.y(), p.z());
  std::string line = text.data();
  if (how.comma)
    for (char& c : line) c = c == '.' ? ',' : c;
  return line;
}

inline std::string colourText(const Writing& how, std::size_t i) {
  if (!how.colours) return {};
  const Colour c = WrittenScan::colourOf(i);
  std::string text;
  for (const int channel : c) (text += ' ') += std::to_string(channel);
  return text;
}

/// The rays in the order of the file.
inline std::vector<std::size_t> orderOf(const WrittenScan& scan, const Writing& how) {
  std::vector<std::size_t> order;
  for (int r = 0; r < scan.rows(); ++r)
    for (int c = 0; c < scan.columns(); ++c)
      order.push_back(scan.profile.rays->index(how.fromTop ? scan.rows() - 1 - r : r, c));
  return order;
}

inline std::string xyzText(const WrittenScan& scan, const Writing& how, bool all, bool head) {
  std::string text = head ? std::to_string(scan.columns()) + " " + std::to_string(scan.rows()) + "\n" : "";
  for (const std::size_t i : orderOf(scan, how))
    if (all || scan.points[i]) text += pointText(scan, how, i) + (scan.points[i] ? colourText(how, i) : "") + "\n";
  return text;
}

inline std::string plyText(const WrittenScan& scan, const Writing& how, bool grid) {
  std::string points;
  std::string cells;
  std::size_t count = 0;
  for (const std::size_t i : orderOf(scan, how)) {
    cells += scan.points[i] ? "1 " + std::to_string(count++) + "\n" : "0\n";
    if (scan.points[i]) points += pointText(scan, how, i) + colourText(how, i) + "\n";
  }
  std::string text = "ply\nformat ascii 1.0\n";
  if (grid)
    text += "obj_info num_cols " + std::to_string(scan.columns()) + "\nobj_info num_rows " +
            std::to_string(scan.rows()) + "\n";
  text += "element vertex " + std::to_string(count) + "\nproperty float x\nproperty float y\nproperty float z\n";
  if (how.colours) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (grid)
    text += "element range_grid " + std::to_string(scan.points.size()) + "\nproperty list uchar int vertex_indices\n";
  return text + "end_header\n" + points + (grid ? cells : "");
}

inline std::string pcdText(const WrittenScan& scan, const Writing& how, bool binary) {
  std::string text = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " +
                     std::to_string(scan.columns()) + "\nHEIGHT " + std::to_string(scan.rows()) +
                     "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(scan.points.size()) + "\nDATA " +
                     (binary ? "binary" : "ascii") + "\n";
  for (const std::size_t i : orderOf(scan, how)) {
    const Colour c = WrittenScan::colourOf(i);
    const std::uint32_t rgb = std::uint32_t{c[0]} << 16 | std::uint32_t{c[1]} << 8 | c[2];
    if (!binary) {
      text += pointText(scan, how, i) + " " + std::to_string(rgb) + "\n";
      continue;
    }
    Eigen::Vector3f p = Eigen::Vector3f::Constant(std::nanf(""));
    if (scan.points[i]) p = (how.unit * (how.T_file_scanner * *scan.points[i])).cast<float>();
    text.append(reinterpret_cast<const char*>(p.data()), sizeof(p));
    text.append(reinterpret_cast<const char*>(&rgb), sizeof(rgb));
  }
  return text;
}

/// Column by column from below, the pose of the head in its matrix.
inline std::string ptxText(const WrittenScan& scan, const Writing& how) {
  std::string text = std::to_string(scan.columns()) + "\n" + std::to_string(scan.rows()) + "\n";
  const Pose T = how.T_file_scanner.inverse();
  const auto line = [](const Vec3& v) {
    return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
  };
  text += line(how.unit * T.translation()) + "\n";
  for (int k = 0; k < 3; ++k) text += line(T.linear().col(k)) + "\n";
  for (int k = 0; k < 3; ++k) text += line(T.linear().col(k)) + " 0\n";
  text += line(how.unit * T.translation()) + " 1\n";
  for (int c = 0; c < scan.columns(); ++c)
    for (int r = 0; r < scan.rows(); ++r) {
      const std::size_t i = scan.profile.rays->index(r, c);
      text += scan.points[i] ? pointText(scan, how, i) + " 0.5" + colourText(how, i) + "\n" : "0 0 0 0.5\n";
    }
  return text;
}

/// A grey PNG of 16 bits.
inline std::string pngOf(const std::vector<std::uint16_t>& grey, std::uint32_t columns, std::uint32_t rows) {
  const auto big = [](std::uint32_t v) {
    return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
                       static_cast<char>(v)};
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big(static_cast<std::uint32_t>(data.size())) + body + big(static_cast<std::uint32_t>(crc));
  };
  std::string raw;
  for (std::uint32_t r = 0; r < rows; ++r) {
    raw += '\0';
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint16_t v = grey[r * columns + c];
      raw += static_cast<char>(v >> 8);
      raw += static_cast<char>(v & 0xFF);
    }
  }
  std::string packed(compressBound(raw.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()), raw.size());
  packed.resize(size);
  return std::string("\x89PNG\r\n\x1a\n") + chunk("IHDR", big(columns) + big(rows) + std::string("\x10\0\0\0\0", 5)) +
         chunk("IDAT", packed) + chunk("IEND", "");
}

/// Depth along the middle ray of a pinhole, in counts, as its camera sees it.
inline std::string depthPng(const WrittenScan& scan, const Pose& T_scanner_camera, double countsPerMillimetre) {
  std::vector<std::uint16_t> counts;
  for (const auto& p : scan.points) {
    const double z = p ? (T_scanner_camera.inverse() * *p).z() : 0.0;
    counts.push_back(static_cast<std::uint16_t>(std::lround(z * countsPerMillimetre)));
  }
  return pngOf(counts, static_cast<std::uint32_t>(scan.columns()), static_cast<std::uint32_t>(scan.rows()));
}

/// The intrinsics of cameraProfile.
inline std::string intrinsicsText(int finer, double countsPerMetre) {
  const double fx = 44.0 * finer / (2.0 * std::tan(0.12));
  const double fy = 40.0 * finer / (2.0 * std::tan(0.12));
  return "{\"fx\": " + std::to_string(fx) + ", \"fy\": " + std::to_string(fy) +
         ", \"cx\": " + std::to_string(0.5 * (44 * finer - 1)) + ", \"cy\": " + std::to_string(0.5 * (40 * finer - 1)) +
         ", \"depth_scale\": " + std::to_string(countsPerMetre) + "}";
}

}  // namespace vantage::testing
