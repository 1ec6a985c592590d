#include "report_pictures.h"

#include <QBuffer>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "acquisition/stand_composites.h"
#include "scenes/model_scene.h"
#include "scenes/ray_picture.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ReportPictures)
};

// How squarely the surface between a sample and its two grid neighbours faces the ray; 0 without neighbours.
double facing(const RangeImage& scan, int row, int column) {
  const RayGrid& rays = *scan.rays;
  const auto at = [&](int r, int c) {
    return rays.index(std::min(r, rays.rows() - 1), std::min(c, rays.columns() - 1));
  };
  const std::size_t here = at(row, column);
  const std::size_t below = at(row + 1, column);
  const std::size_t beside = at(row, column + 1);
  if (!scan.valid(here) || !scan.valid(below) || !scan.valid(beside)) return 0.0;
  const Vec3 p = scan.point(here);
  const Vec3 normal = (scan.point(below) - p).cross(scan.point(beside) - p);
  const double length = normal.norm();
  return length > 0.0 ? std::abs(normal.dot(rays.ray(here).direction)) / length : 0.0;
}

const QColor kEmpty(0x22, 0x27, 0x2e);  // where a scan has no sample
constexpr QSize kStandPicture(400, 300);
constexpr int kDiscSides = 96;
constexpr double kDiscWider = 1.25;  // than what stands on it

// A disc below what stands on a table.
Mesh discBelow(const Mesh& mesh, const Pose& T_table_mesh) {
  double radius = 1.0;
  double lowest = 0.0;
  for (const Vec3& v : mesh.vertices) {
    const Vec3 p = T_table_mesh * v;
    radius = std::max(radius, std::hypot(p.x(), p.y()));
    lowest = std::min(lowest, p.z());
  }
  Mesh disc;
  disc.vertices.emplace_back(0.0, 0.0, lowest);
  for (std::uint32_t i = 0; i < kDiscSides; ++i) {
    const double azimuth = 2.0 * kPi * i / kDiscSides;
    disc.vertices.emplace_back(kDiscWider * radius * std::cos(azimuth), kDiscWider * radius * std::sin(azimuth),
                               lowest);
    disc.triangles.push_back({0, 1 + i, 1 + (i + 1) % kDiscSides});
  }
  return disc;
}

QImage standingPicture(const Mesh& mesh, const Pose& T_table_mesh) {
  const Theme& theme = lightTheme();
  const Mesh table = discBelow(mesh, T_table_mesh);
  const RayCaster body(mesh);
  const RayCaster disc(table);
  BoundingBox box = boundingBox(table);
  for (const Vec3& v : mesh.vertices) box.extend(T_table_mesh * v);
  const auto plain = [](const QColor& colour) { return [rgb = toRgb(colour)](std::uint32_t) { return rgb; }; };
  const std::vector<PicturedSurface> surfaces{{&body, T_table_mesh, plain(theme.surface)},
                                              {&disc, Pose::Identity(), plain(theme.table)}};
  const Camera camera = presetCamera(CameraPreset::Oblique, box, {}, std::nullopt,
                                     static_cast<double>(kStandPicture.width()) / kStandPicture.height());
  return rayPicture(surfaces, camera, kStandPicture, theme);
}

}  // namespace

QImage cropped(const QImage& image) {
  constexpr double kAround = 0.06;
  QRect filled;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.pixel(x, y) != kEmpty.rgb()) filled |= QRect(x, y, 1, 1);
  if (filled.isEmpty()) return image;
  const int around = 2 + static_cast<int>(kAround * std::max(filled.width(), filled.height()));
  return image.copy(filled.adjusted(-around, -around, around, around) & image.rect());
}

QImage scanImage(const RangeImage& scan, int step, const std::function<QRgb(std::size_t, QRgb)>& repaint) {
  const RayGrid& rays = *scan.rays;
  QImage image((rays.columns() + step - 1) / step, (rays.rows() + step - 1) / step, QImage::Format_RGB32);
  image.fill(kEmpty);
  for (int row = 0; row < rays.rows(); row += step)
    for (int column = 0; column < rays.columns(); column += step) {
      const std::size_t ray = rays.index(row, column);
      if (!scan.valid(ray)) continue;
      const int grey = 50 + static_cast<int>(195.0 * facing(scan, row, column));
      const QRgb surface = qRgb(grey, grey, std::max(0, grey - 8));
      image.setPixel(column / step, row / step, repaint ? repaint(ray, surface) : surface);
    }
  // Rows may run up and columns to the left: set the picture upright as somebody at the scanner sees it.
  const auto place = [&](int row, int column) {
    const RangingRay& ray = rays.ray(rays.index(row, column));
    return Vec3(ray.origin + 300.0 * ray.direction);
  };
  const bool up = place(rays.rows() - 1, 0).z() > place(0, 0).z();
  const Vec3 across = place(0, rays.columns() - 1) - place(0, 0);
  const Vec3 right = rays.ray(rays.size() / 2).direction.cross(Vec3::UnitZ());
  return image.mirrored(across.dot(right) < 0.0, up);
}

ReportPicture toReportPicture(const QImage& image, const QString& caption) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return {caption.toStdString(), bytes.toStdString()};
}

std::vector<ReportPicture> scanPictures(const AcquisitionState& state) {
  std::vector<ReportPicture> pictures;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    const std::optional<int> position = scan->station().position;
    pictures.push_back(toReportPicture(cropped(scanImage(*scan->view.image)),
                                       position ? Text::tr("Scan %1, position %2").arg(scan->number).arg(*position)
                                                : Text::tr("Scan %1").arg(scan->number)));
  }
  return pictures;
}

std::vector<ReportPicture> standPictures(const AcquisitionState& state) {
  std::vector<ReportPicture> pictures;
  if (state.stands.size() < 2) return pictures;
  for (int stand = 0; stand <= state.stand(); ++stand) {
    const AcquisitionState composite = withComposite(state, compositeOf(state, stand));
    // Nothing was scanned in it yet.
    const Mesh mesh = composite.model ? composite.model->mesh : Mesh{};
    const QString caption =
        composite.model ? Text::tr("Stand %1").arg(stand) : Text::tr("Stand %1, no scan").arg(stand);
    pictures.push_back(toReportPicture(standingPicture(mesh, tableOf(state, stand).inverse()), caption));
  }
  return pictures;
}

}  // namespace vantage
