#include "io/assimp_import.h"

#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstring>
#include <new>
#include <string_view>

#include "base/errors.h"
#include "io/child_process.h"
#include "io/file_bytes.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::uintmax_t kMegabyte = 1ULL << 20;
// Parts of a scene may stand in it many times; together they may not have more corners than this.
constexpr std::size_t kMaxCorners = 150'000'000;

void appendMesh(const aiMesh& source, const aiMatrix4x4& T_scene_mesh, PolygonSoup& soup) {
  if (soup.corners.size() + 3ULL * source.mNumFaces > kMaxCorners) throw std::bad_alloc();
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  for (unsigned i = 0; source.mVertices != nullptr && i < source.mNumVertices; ++i) {
    const aiVector3D p = T_scene_mesh * source.mVertices[i];
    soup.points.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned f = 0; source.mFaces != nullptr && f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices < 3) continue;  // points and lines
    for (unsigned k = 0; k < face.mNumIndices; ++k)
      soup.corners.push_back(face.mIndices[k] < source.mNumVertices ? base + face.mIndices[k] : kNoIndex);
    soup.endPolygon();
  }
}

void appendNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& T_scene_parent, PolygonSoup& soup) {
  const aiMatrix4x4 T_scene_node = T_scene_parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i)
    if (node.mMeshes[i] < scene.mNumMeshes && scene.mMeshes[node.mMeshes[i]] != nullptr)
      appendMesh(*scene.mMeshes[node.mMeshes[i]], T_scene_node, soup);
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    if (node.mChildren[i] != nullptr) appendNode(scene, *node.mChildren[i], T_scene_node, soup);
}

template <typename T>
void sendVector(const ChildSend& send, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  send(&count, sizeof(count));
  send(values.data(), values.size() * sizeof(T));
}

// In the child: one byte 1 and the soup, or one byte 0 and a message.
void importAndSend(const std::string& path, const ChildSend& send) {
  Assimp::Importer importer;
  // Axes stay as they are in the file.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(path, 0);
  const char ok = scene != nullptr && scene->mRootNode != nullptr ? 1 : 0;
  if (ok == 0) {
    const std::string_view message = importer.GetErrorString();
    if (message.find("bad_alloc") != std::string_view::npos) throw std::bad_alloc();
    send(&ok, 1);
    return send(message.data(), message.size());
  }
  PolygonSoup soup;
  appendNode(*scene, *scene->mRootNode, aiMatrix4x4(), soup);
  send(&ok, 1);
  sendVector(send, soup.points);
  sendVector(send, soup.corners);
  sendVector(send, soup.ends);
}

class SoupReader {
 public:
  explicit SoupReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  std::vector<T> vector() {
    std::uint64_t count = 0;
    copy(&count, sizeof(count));
    if (count > bytes_.size() / sizeof(T)) throw InvalidInput("damaged");
    std::vector<T> values(count);
    copy(values.data(), count * sizeof(T));
    return values;
  }

 private:
  void copy(void* to, std::size_t count) {
    if (count > bytes_.size()) throw InvalidInput("damaged");
    std::memcpy(to, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }

  std::string_view bytes_;
};

bool isConsistent(const PolygonSoup& soup) {
  return std::is_sorted(soup.ends.begin(), soup.ends.end()) &&
         (soup.ends.empty() ? 0 : soup.ends.back()) == soup.corners.size();
}

// What assimp said, as one line that can be shown.
std::string printable(std::string_view message) {
  std::string text;
  for (const char c : message.substr(0, 200))
    text += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? ' ' : c;
  return text.empty() ? "no reason given" : text;
}

}  // namespace

PolygonSoup importWithAssimp(const std::string& path, const Progress& progress) {
  const std::uintmax_t size = checkedFileSize(path);
  ChildLimits limits;
  limits.cpuSeconds = 3.0 + static_cast<double>(size) / static_cast<double>(kMegabyte);
  limits.wallSeconds = 3.0 * limits.cpuSeconds;
  limits.memoryBytes = std::max<std::uintmax_t>(1024 * kMegabyte, 24 * size);
  const ChildResult result = runInChild([&](const ChildSend& send) { importAndSend(path, send); }, limits, progress);
  if (result.end == ChildEnd::Crashed)
    throw InvalidInput(
        path +
        ": cannot be read: the mesh importer crashed on it, so it is damaged or has features that are not supported");
  if (result.end == ChildEnd::OutOfTime)
    throw InvalidInput(path + ": is damaged or too complex: the mesh importer was stopped after " +
                       std::to_string(static_cast<int>(limits.cpuSeconds)) + " s");
  if (result.end == ChildEnd::OutOfMemory)
    throw InvalidInput(path + ": is damaged or too complex: the mesh importer needed more than " +
                       std::to_string(limits.memoryBytes / kMegabyte) + " MiB");
  const std::string_view output = result.output;
  if (output.empty() || output[0] != 1)
    throw InvalidInput(path + ": is no mesh that can be read: " + printable(output.substr(output.empty() ? 0 : 1)));
  SoupReader reader(output.substr(1));
  PolygonSoup soup;
  soup.points = reader.vector<Vec3>();
  soup.corners = reader.vector<std::uint32_t>();
  soup.ends = reader.vector<std::size_t>();
  if (!isConsistent(soup)) throw InvalidInput(path + ": is damaged: the mesh importer gave polygons without corners");
  return soup;
}

std::vector<std::string> assimpExtensions() {
  std::string list;
  Assimp::Importer().GetExtensionList(list);
  std::vector<std::string> extensions;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(';', at), list.size());
    if (end - at > 2) extensions.push_back(lowerCase(std::string_view(list).substr(at + 2, end - at - 2)));
    at = end + 1;
  }
  std::sort(extensions.begin(), extensions.end());
  extensions.erase(std::unique(extensions.begin(), extensions.end()), extensions.end());
  return extensions;
}

}  // namespace vantage
