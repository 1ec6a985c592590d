#include "io/mesh_reader.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "io/assimp_import.h"
#include "io/file_kind.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_mesh.h"
#include "io/stl_reader.h"
#include "io/three_mf_reader.h"
#include "io/zip_archive.h"

namespace vantage {
namespace {

// Zipped formats other than 3MF are checked before the importer unpacks them.
PolygonSoup readOther(const std::string& path, const MeshReadOptions& options, const Progress& progress) {
  if (looksLikeZip(readHead(path, 4))) static_cast<void>(ZipArchive(FileBytes(path), options.maxUnpackedBytes));
  return importWithAssimp(path, progress);
}

PolygonSoup readSoup(const std::string& path, const MeshReadOptions& options, const Progress& progress) {
  switch (detectFileKind(path)) {
    case FileKind::Ply:
      return readPlySoup(FileBytes(path), progress);
    case FileKind::Stl:
      return readStlSoup(FileBytes(path), progress);
    case FileKind::Obj:
      return readObjSoup(FileBytes(path), progress);
    case FileKind::Off:
      return readOffSoup(FileBytes(path), progress);
    case FileKind::ThreeMf:
      return readThreeMfSoup(FileBytes(path), options.maxUnpackedBytes, progress);
    case FileKind::OtherMesh:
      return readOther(path, options, progress);
    case FileKind::Pcd:
    case FileKind::Ptx:
    case FileKind::TextPoints:
      throw InvalidInput(path + ": is a point cloud, expected a mesh with triangles");
    case FileKind::DepthPng:
      throw InvalidInput(path + ": is a picture, expected a mesh with triangles");
    case FileKind::ScanPoses:
      throw InvalidInput(path + ": is a list of scan poses, expected a mesh");
    case FileKind::Profile:
      throw InvalidInput(path + ": is a JSON file, expected a mesh");
    case FileKind::Session:
      throw InvalidInput(path + ": is a session, expected a mesh");
  }
  throw InvalidInput(path + ": is of no known kind");
}

void refuseEmptySoup(const std::string& path, const PolygonSoup& soup) {
  if (!soup.ends.empty()) return;
  if (soup.points.empty()) throw InvalidInput(path + ": has no geometry, expected a mesh with triangles");
  throw InvalidInput(path + ": has " + std::to_string(soup.points.size()) +
                     " points but no triangles, expected a mesh with triangles");
}

}  // namespace

LoadedMesh loadMesh(const std::string& path, const MeshReadOptions& options, const Progress& progress) {
  LoadedMesh loaded;
  loaded.format = extensionOf(path);
  PolygonSoup soup = readSoup(path, options, progress.part(0.0, 0.6));
  refuseEmptySoup(path, soup);
  loaded.mesh = repairedMesh(std::move(soup), loaded.repair, progress.part(0.6, 1.0));
  if (loaded.mesh.empty()) throw InvalidInput(path + ": has no usable triangle: " + describe(loaded.repair));
  return loaded;
}

std::vector<std::string> readableMeshExtensions() {
  std::vector<std::string> extensions = assimpExtensions();
  for (const char* own : {"3mf", "obj", "off", "ply", "stl"}) extensions.emplace_back(own);
  std::sort(extensions.begin(), extensions.end());
  extensions.erase(std::unique(extensions.begin(), extensions.end()), extensions.end());
  return extensions;
}

}  // namespace vantage
