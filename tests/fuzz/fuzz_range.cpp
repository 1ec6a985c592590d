#include <cmath>

#include "base/errors.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch_file.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "io/scan_reader.h"
#include "scanner/triangulation.h"

// An input is a PLY range file, or, behind a byte of 1, a list of poses, of 2 a PCD file, of 3 a PTX file.

namespace vantage::testing {
namespace {

constexpr const char* kAscii =
    "ply\nformat ascii 1.0\nobj_info num_cols 3\nobj_info num_rows 2\nelement vertex 5\nproperty float x\n"
    "property float y\nproperty float z\nelement range_grid 6\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0.01\n0.01 0 0.011\n0.02 0 0.012\n0 0.01 0.013\n0.01 0.01 0.01\n1 0\n1 1\n1 2\n1 3\n1 4\n0\n";
constexpr const char* kPoses =
    "camera 0 0 0 0 0 0 1\nmesh a.ply 0 0 0 0 0 0 1\nbmesh bun000.ply 0 0 0 0 0 0 1\n"
    "bmesh bun045.ply -0.0520211 -0.000383981 -0.0109223 0.00548449 -0.294635 -0.0038555 0.955586\n";

constexpr const char* kPcd =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 2\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 6\nDATA ascii\n0 0 1\nnan nan nan\n0 1 1\n1 0 1\n1 1 1\n1 2 1\n";
constexpr const char* kPtx =
    "2\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n0 0 0 0.5\n1 0 0 0.5\n1 0 0.1 0.5\n"
    "1 0.1 -0.1 0.5\n1 0.1 0 0.5\n1 0.1 0.1 0.5\n";

// Every way of reading the file as scans.
void readAs(const std::string& path) {
  for (const char* frame : {"auto", "camera", "x+", "world", "cylinder"}) {
    try {
      ScanReadingOptions options;
      options.frame = parseFrame(frame);
      options.unit = 1.0;
      for (const ReadScan& scan : readScans({path}, nullptr, nullptr, options))
        static_cast<void>(triangulate(scan.image, {}));
    } catch (const Error&) {
      continue;
    }
  }
}

// A wave, sampled along parallel rays, written by us.
void writeOwnFile(const std::string& path) {
  constexpr int kRows = 6;
  constexpr int kColumns = 7;
  std::vector<RangingRay> rays;
  RangeImage image;
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) {
      rays.push_back({Vec3(c, r, 100), Vec3(0, 0, -1)});
      image.range.push_back((r + c) % 5 == 4 ? kNoSample : static_cast<float>(90.0 + std::sin(r + 0.5 * c)));
    }
  }
  image.rays = std::make_shared<const RayGrid>(kRows, kColumns, std::move(rays), std::vector<Vec3>(), 0);
  writeRangeFile(image, path);
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  const ScratchFile file(".ply");
  writeOwnFile(file.path());
  return {kAscii, file.read(), std::string(1, '\1') + kPoses, std::string(1, '\2') + kPcd, std::string(1, '\3') + kPtx};
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using vantage::testing::ScratchFile;
  static const ScratchFile range(".ply");
  static const ScratchFile poses(".conf");
  static const ScratchFile pcd(".pcd");
  static const ScratchFile ptx(".ptx");
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const char kind = bytes.empty() || bytes[0] < 1 || bytes[0] > 3 ? '\0' : bytes[0];
  const ScratchFile& file = kind == 1 ? poses : kind == 2 ? pcd : kind == 3 ? ptx : range;
  file.write(kind == 0 ? bytes : bytes.substr(1));
  try {
    if (kind == 1) {
      static_cast<void>(vantage::readScanPoses(poses.path(), 1.0));
      return 0;
    }
    vantage::testing::readAs(file.path());
    if (kind == 0) static_cast<void>(vantage::triangulate(vantage::readRangeFile(range.path()), {}));
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
