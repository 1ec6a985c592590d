#include "io/file_info.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/file_kind.h"
#include "io/grid_file.h"
#include "io/mesh_colours.h"
#include "io/mesh_reader.h"
#include "io/model_reader.h"
#include "io/obj_reader.h"
#include "io/ply_grid.h"
#include "io/ply_mesh.h"
#include "io/range_files.h"
#include "io/scan_poses.h"
#include "scanner/profile.h"

namespace vantage {
namespace {

void add(FileInfo& info, const std::string& key, std::size_t count) {
  info.facts.emplace_back(key, static_cast<std::int64_t>(count));
}
void add(FileInfo& info, const std::string& key, double value) {
  info.facts.emplace_back(key, value);
}
void add(FileInfo& info, const std::string& key, std::string text) {
  info.facts.emplace_back(key, std::move(text));
}
void add(FileInfo& info, const std::string& key, const Vec3& v) {
  info.facts.emplace_back(key, std::vector<double>{v.x(), v.y(), v.z()});
}

void addBox(FileInfo& info, const BoundingBox& box, const std::string& unit) {
  add(info, "extent" + unit, box.size());
  add(info, "min" + unit, box.min);
  add(info, "max" + unit, box.max);
}

void addRepair(FileInfo& info, const MeshRepair& repair) {
  if (repair.nothing()) return;
  add(info, "repairs", describe(repair));
}

// Units of a mesh file are not known, but the engine takes them as millimetres.
void addMesh(FileInfo& info, const Mesh& mesh) {
  const MeshMeasures m = measure(mesh);
  add(info, "vertices", m.vertices);
  add(info, "triangles", m.triangles);
  add(info, "components", m.components);
  add(info, "boundary_edges", m.boundaryEdges);
  add(info, "boundary_loops", m.boundaryLoops);
  add(info, "non_manifold_edges", m.nonManifoldEdges);
  add(info, "area_mm2", m.area);
  add(info, "mean_edge_mm", m.meanEdgeLength);
  addBox(info, m.box, "_mm");
}

// Of PLY and OBJ.
void addColours(FileInfo& info, const std::string& path, const Progress& progress) {
  const std::size_t coloured = readMeshColours(path, progress).size();
  if (coloured > 0) add(info, "coloured_vertices", coloured);
}

FileInfo describeMesh(const std::string& path, const Progress& progress) {
  const LoadedMesh loaded = loadMesh(path, {}, progress);
  FileInfo info{FileContent::Mesh, {}};
  add(info, "format", loaded.format);
  addMesh(info, loaded.mesh);
  addColours(info, path, progress);
  addRepair(info, loaded.repair);
  return info;
}

FileInfo describeModel(const std::string& path, const Progress& progress) {
  const Model model = readModel(path, progress);
  FileInfo info{FileContent::Model, {}};
  add(info, "format", std::string("ply"));
  addMesh(info, model.mesh);
  addColours(info, path, progress);
  std::vector<std::uint32_t> views = model.triangleView;
  std::sort(views.begin(), views.end());
  add(info, "views", static_cast<std::size_t>(std::unique(views.begin(), views.end()) - views.begin()));
  double sum = 0.0;
  for (const float c : model.confidence) sum += static_cast<double>(c);
  if (!model.confidence.empty()) add(info, "mean_confidence", sum / static_cast<double>(model.confidence.size()));
  return info;
}

FileInfo describeRange(const std::string& path, const Progress& progress) {
  const RangeGrid grid = readRangeGrid(path, {}, progress);
  const SampleGrid& samples = grid.samples;
  FileInfo info{FileContent::RangeImage, {}};
  add(info, "rows", static_cast<std::size_t>(samples.rows));
  add(info, "columns", static_cast<std::size_t>(samples.columns));
  add(info, "samples", samples.points.size());
  if (!samples.colours.empty()) add(info, "coloured_samples", samples.colours.size());
  add(info, "filled", static_cast<double>(samples.points.size()) / static_cast<double>(samples.cell.size()));
  add(info, "mm_per_unit", grid.scale);
  if (grid.bytesLeftOver > 0) add(info, "bytes_left_over", grid.bytesLeftOver);
  addBox(info, boundingBox(Mesh{samples.points, {}}), "_mm");
  return info;
}

FileInfo describePoints(const std::vector<Vec3>& points, const std::string& format) {
  FileInfo info{FileContent::Points, {}};
  add(info, "format", format);
  add(info, "points", points.size());
  add(info, "triangles", std::size_t{0});
  addBox(info, boundingBox(Mesh{points, {}}), "");
  return info;
}

FileInfo describeText(const std::string& path, const Progress& progress) {
  const GridFile file = readSamples(path, progress);
  return file.organised ? describeRange(path, progress) : describePoints(file.samples.points, "xyz");
}

FileInfo describePly(const std::string& path, const Progress& progress) {
  const PlyHeader header = readPlyHeader(path);
  if (isPlyGrid(header)) return describeRange(path, progress);
  if (isModel(header)) return describeModel(path, progress);
  const PlyElement* face = header.find("face");
  if (face == nullptr || face->count == 0) {
    const PolygonSoup soup = readPlySoup(FileBytes(path), progress);
    if (soup.ends.empty() && !soup.points.empty()) return describePoints(soup.points, "ply");
  }
  return describeMesh(path, progress);
}

FileInfo describeObj(const std::string& path, const Progress& progress) {
  const PolygonSoup soup = readObjSoup(FileBytes(path), progress);
  if (soup.ends.empty() && !soup.points.empty()) return describePoints(soup.points, "obj");
  return describeMesh(path, progress);
}

FileInfo describePoses(const std::string& path) {
  const auto poses = readScanPoses(path, 1.0);
  FileInfo info{FileContent::ScanPoses, {}};
  add(info, "poses", poses.size());
  for (const ScanPose& pose : poses) add(info, "scan", pose.file);
  return info;
}

FileInfo describeProfile(const std::string& path) {
  const ScannerProfile profile = loadProfile(path);
  FileInfo info{FileContent::Profile, {}};
  add(info, "name", profile.name);
  add(info, "type", profile.type);
  add(info, "rows", static_cast<std::size_t>(profile.rays->rows()));
  add(info, "columns", static_cast<std::size_t>(profile.rays->columns()));
  add(info, "positions", profile.workspace.size());
  add(info, "breakdown_angle_deg", degrees(profile.breakdownAngle));
  add(info, "min_range_mm", profile.minRange);
  add(info, "max_range_mm", profile.maxRange);
  add(info, "volume_radius_mm", profile.viewingVolume.radius);
  add(info, "volume_height_mm", profile.viewingVolume.height);
  return info;
}

}  // namespace

std::string nameOf(FileContent content) {
  constexpr std::array<const char*, 7> kNames{"mesh",       "model",   "points", "range_image",
                                              "scan_poses", "profile", "session"};
  return kNames[static_cast<std::size_t>(content)];
}

const FactValue& FileInfo::at(const std::string& key) const {
  const auto it = std::find_if(facts.begin(), facts.end(), [&](const auto& fact) { return fact.first == key; });
  if (it == facts.end()) throw InvalidInput("the file has no fact '" + key + "'");
  return it->second;
}

std::string toText(const FactValue& value) {
  auto number = [](double v) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", v);
    return std::string(text.data());
  };
  if (const auto* count = std::get_if<std::int64_t>(&value)) return std::to_string(*count);
  if (const auto* real = std::get_if<double>(&value)) return number(*real);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  std::string joined;
  for (const double v : std::get<std::vector<double>>(value)) joined += (joined.empty() ? "" : " x ") + number(v);
  return joined;
}

FileInfo describeFile(const std::string& path, const Progress& progress) {
  switch (detectFileKind(path)) {
    case FileKind::Ply:
      return describePly(path, progress);
    case FileKind::Obj:
      return describeObj(path, progress);
    case FileKind::Stl:
    case FileKind::Off:
    case FileKind::ThreeMf:
    case FileKind::OtherMesh:
      return describeMesh(path, progress);
    case FileKind::Pcd:
    case FileKind::Ptx:
    case FileKind::DepthPng:
      return describeRange(path, progress);
    case FileKind::TextPoints:
      return describeText(path, progress);
    case FileKind::ScanPoses:
      return describePoses(path);
    case FileKind::Profile:
      return describeProfile(path);
    case FileKind::Session:
      return {FileContent::Session, {}};
  }
  throw InvalidInput(path + ": is of no known kind");
}

}  // namespace vantage
