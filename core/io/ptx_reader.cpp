#include "io/ptx_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kPerCheckpoint = 65536;

class PtxReader {
 public:
  PtxReader(const FileBytes& file, const Progress& progress)
      : file_(file), progress_(progress), text_(file.text(), file.path()) {}

  GridFile read() {
    const std::size_t columns = size("the number of columns");
    const std::size_t rows = size("the number of rows");
    if (rows > kMaxGridCells / columns || rows * columns > file_.size() / 2 + 1)
      text_.fail("the PTX file is too short for " + std::to_string(columns) + " x " + std::to_string(rows) + " points");
    for (int i = 0; i < 12; ++i) static_cast<void>(text_.number("the scanner's place and axes"));
    GridFile file;
    file.T_world_scanner = readPose();
    file.samples = gridOf(rows, columns, readPoints(rows, columns), file_.path());
    if (coloured_) file.samples.colours = std::move(colours_);
    file.inMetres = true;
    file.fromOrigin = true;
    if (!text_.field().empty())
      text_.fail("the PTX file goes on behind its " + std::to_string(columns) + " x " + std::to_string(rows) +
                 " points: expected one scan in a file, export every scan to a file of its own");
    return file;
  }

 private:
  std::size_t size(const char* what) {
    const std::int64_t value = text_.integer(what);
    if (value < 1 || value > static_cast<std::int64_t>(kMaxGridCells))
      text_.fail("the PTX file has " + std::to_string(value) + " for " + what + ", expected 1 to " +
                 std::to_string(kMaxGridCells));
    return static_cast<std::size_t>(value);
  }

  // Points are rows, so the matrix stands there transposed.
  Pose readPose() {
    Eigen::Matrix4d matrix;
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) matrix(row, column) = text_.number("the matrix of the scan");
    const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
    if (!matrix.allFinite() || !(turn * turn.transpose()).isIdentity(1e-3))
      text_.fail("the matrix of the PTX scan is no rotation with a translation");
    if (turn.determinant() < 0.0)
      text_.fail("the matrix of the PTX scan mirrors: its coordinates are left-handed, expected right-handed ones");
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
    pose.translation() = matrix.topRightCorner<3, 1>();
    return pose;
  }

  std::vector<Vec3> readPoints(std::size_t rows, std::size_t columns) {
    std::vector<Vec3> points(rows * columns);
    colours_.assign(points.size(), Colour{});
    static_cast<void>(text_.nextLine());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % kPerCheckpoint == 0) progress_.checkpoint(static_cast<double>(i) / static_cast<double>(points.size()));
      const std::size_t cell = i % rows * columns + i / rows;
      points[cell] = readPoint(colours_[cell]);
    }
    return points;
  }

  // Behind the coordinates stand intensity and colours, or nothing.
  Vec3 readPoint(Colour& colour) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = text_.number("the three coordinates of a point");
    if (!text_.fieldOnLine().empty()) {
      for (std::uint8_t& channel : colour) {
        const auto value = parseInteger(text_.fieldOnLine());
        if (!value) break;
        channel = static_cast<std::uint8_t>(std::clamp<std::int64_t>(*value, 0, 255));
        coloured_ = true;
      }
    }
    static_cast<void>(text_.nextLine());
    return p.isZero(0.0) ? Vec3::Constant(std::numeric_limits<double>::quiet_NaN()) : p;
  }

  const FileBytes& file_;
  const Progress& progress_;
  TextScanner text_;
  std::vector<Colour> colours_;
  bool coloured_ = false;
};

}  // namespace

GridFile readPtx(const FileBytes& file, const Progress& progress) {
  return PtxReader(file, progress).read();
}

}  // namespace vantage
