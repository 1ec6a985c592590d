#include "io/three_mf_reader.h"

#include <array>
#include <map>
#include <optional>

#include "base/errors.h"
#include "io/text_scanner.h"
#include "io/xml_scanner.h"
#include "io/zip_archive.h"

namespace vantage {
namespace {

// Parts of an object may be placed many times and deeply; a file with more than this wants to exhaust memory.
constexpr std::size_t kMaxTriangles = 50'000'000;
constexpr std::size_t kMaxPlacements = 1'000'000;
constexpr int kMaxDepth = 32;

using Transform = Eigen::Affine3d;

struct Placed {
  std::string object;  // its id
  std::string part;    // the model part that has it
  Transform T_parent_object = Transform::Identity();
};

struct Object {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Placed> components;
  bool isSupport = false;
};

struct ModelPart {
  double millimetres = 1.0;  // per unit
  std::map<std::string, Object> objects;
  std::vector<Placed> items;
};

// Reads one model part (3MF Core Specification, chapter 3): objects and what is built of them.
class PartReader {
 public:
  PartReader(std::string_view text, const std::string& file, const std::string& part, const Progress& progress)
      : part_(part), xml_(text, file, part), progress_(progress) {}

  ModelPart read() {
    bool isModel = false;
    for (XmlTag tag; xml_.next(tag);) {
      if (tag.closes && tag.name == "object") object_ = nullptr;
      if (!tag.opens) continue;
      if (tag.name == "model") readModel(tag);
      isModel = isModel || tag.name == "model";
      if (tag.name == "object") readObject(tag);
      if (tag.name == "item") model_.items.push_back(readPlaced(tag));
      if (object_ == nullptr) continue;
      if (tag.name == "vertex") readVertex(tag);
      if (tag.name == "triangle") readTriangle(tag);
      if (tag.name == "component") object_->components.push_back(readPlaced(tag));
      if (tag.closes && tag.name == "object") object_ = nullptr;
    }
    if (!isModel) xml_.fail("has no element 'model', expected a 3MF model");
    return std::move(model_);
  }

 private:
  void readModel(const XmlTag& tag) {
    static const std::map<std::string_view, double> kUnits{{"micron", 1e-3}, {"millimeter", 1.0}, {"centimeter", 10.0},
                                                           {"inch", 25.4},   {"foot", 304.8},     {"meter", 1000.0}};
    const std::string_view unit = tag.attribute("unit");
    const auto known = kUnits.find(unit.empty() ? "millimeter" : unit);
    if (known == kUnits.end())
      xml_.fail("the unit is " + inQuotes(unit) + ", expected micron, millimeter, centimeter, inch, foot or meter");
    model_.millimetres = known->second;
    checkExtensions(tag);
  }

  // A file that needs extensions we have never heard of may mean something else than its meshes say.
  void checkExtensions(const XmlTag& tag) const {
    TextScanner prefixes(tag.attribute("requiredextensions"), {});
    for (std::string_view prefix = prefixes.field(); !prefix.empty(); prefix = prefixes.field()) {
      const std::string_view space = tag.attribute("xmlns:" + std::string(prefix));
      if (!space.starts_with("http://schemas.microsoft.com/3dmanufacturing/") &&
          !space.starts_with("http://schemas.3mf.io/"))
        xml_.fail("the extension " + inQuotes(prefix) + " is required but not known");
    }
  }

  void readObject(const XmlTag& tag) {
    const std::string id(tag.attribute("id"));
    if (id.empty()) xml_.fail("an object has no id");
    if (model_.objects.count(id) != 0) xml_.fail("the object " + inQuotes(id) + " is given twice");
    object_ = &model_.objects[id];
    object_->isSupport = tag.attribute("type") == "support";
  }

  double readNumber(const XmlTag& tag, std::string_view key) const {
    const auto value = parseNumber(tag.attribute(key));
    if (!value)
      xml_.fail("the " + std::string(tag.name) + "'s " + std::string(key) + " is " + inQuotes(tag.attribute(key)) +
                ", expected a number");
    return *value;
  }

  void readVertex(const XmlTag& tag) {
    if (object_->vertices.size() % 65536 == 0) progress_.checkpoint(0.0);
    object_->vertices.emplace_back(readNumber(tag, "x"), readNumber(tag, "y"), readNumber(tag, "z"));
  }

  void readTriangle(const XmlTag& tag) {
    constexpr std::array<std::string_view, 3> kCorners{"v1", "v2", "v3"};
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view key = kCorners[k];
      const auto index = parseInteger(tag.attribute(key));
      if (!index)
        xml_.fail("the triangle's " + std::string(key) + " is " + inQuotes(tag.attribute(key)) + ", expected a vertex");
      t[k] =
          *index >= 0 && *index < static_cast<std::int64_t>(kNoIndex) ? static_cast<std::uint32_t>(*index) : kNoIndex;
    }
    object_->triangles.push_back(t);
  }

  Placed readPlaced(const XmlTag& tag) const {
    Placed placed;
    placed.object = tag.attribute("objectid");
    placed.part = tag.attribute("path").empty() ? part_ : withoutEntities(tag.attribute("path"));
    const std::string_view transform = tag.attribute("transform");
    if (transform.empty()) return placed;
    TextScanner fields(transform, {});
    std::array<double, 12> m{};
    for (double& value : m) {
      const auto number = parseNumber(fields.field());
      if (!number) xml_.fail("the transform is " + inQuotes(transform) + ", expected twelve numbers");
      value = *number;
    }
    // Points are rows there: p' = p M.
    placed.T_parent_object.linear() << m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8];
    placed.T_parent_object.translation() = Vec3(m[9], m[10], m[11]);
    if (!(std::abs(placed.T_parent_object.linear().determinant()) > 0.0))
      xml_.fail("the transform " + inQuotes(transform) + " leaves no volume");
    return placed;
  }

  const std::string& part_;
  XmlScanner xml_;
  const Progress& progress_;
  ModelPart model_;
  Object* object_ = nullptr;
};

class ThreeMfReader {
 public:
  ThreeMfReader(const FileBytes& file, std::uintmax_t maxUnpacked, const Progress& progress)
      : file_(file), archive_(file, maxUnpacked), progress_(progress) {}

  PolygonSoup read() {
    const std::string start = findStart();
    const ModelPart& model = part(start);
    for (const Placed& item : model.items) place(item, Transform::Identity(), model.millimetres, 0);
    return std::move(soup_);
  }

 private:
  // The part that the package's relationships name; any model part when they do not.
  std::string findStart() const {
    if (const ZipMember* relations = archive_.find("_rels/.rels")) {
      const std::string text = archive_.unpack(*relations);
      XmlScanner xml(text, file_.path(), relations->name);
      for (XmlTag tag; xml.next(tag);)
        if (tag.name == "Relationship" && tag.attribute("Type").ends_with("/3dmodel"))
          return withoutEntities(tag.attribute("Target"));
    }
    for (const ZipMember& member : archive_.members())
      if (lowerCase(member.name).ends_with(".model")) return member.name;
    throw InvalidInput(file_.path() + ": has no 3D model in it, expected a 3MF archive");
  }

  const ModelPart& part(const std::string& name) {
    const auto found = parts_.find(name);
    if (found != parts_.end()) return found->second;
    const ZipMember* member = archive_.find(name);
    if (member == nullptr)
      throw InvalidInput(file_.path() + ": names the part " + inQuotes(name) + ", which is not in the archive");
    std::string text = archive_.unpack(*member);
    if (std::string ascii = asciiFromUtf16(text); !ascii.empty()) text = std::move(ascii);
    return parts_[name] = PartReader(text, file_.path(), name, progress_).read();
  }

  void place(const Placed& placed, const Transform& T_scene_parent, double millimetres, int depth) {
    progress_.checkpoint(0.5);
    if (depth > kMaxDepth || ++placements_ > kMaxPlacements)
      throw InvalidInput(file_.path() + ": places its objects more than " + std::to_string(kMaxPlacements) +
                         " times or " + std::to_string(kMaxDepth) + " deep");
    const auto& objects = part(placed.part).objects;
    const auto object = objects.find(placed.object);
    if (object == objects.end())
      throw InvalidInput(file_.path() + ": " + placed.part + " has no object " + inQuotes(placed.object) +
                         ", which is to be placed");
    if (object->second.isSupport) return;
    const Transform T_scene_object = T_scene_parent * placed.T_parent_object;
    addMesh(object->second, T_scene_object, millimetres);
    for (const Placed& component : object->second.components) place(component, T_scene_object, millimetres, depth + 1);
  }

  void addMesh(const Object& object, const Transform& T_scene_object, double millimetres) {
    if (soup_.ends.size() + object.triangles.size() > kMaxTriangles ||
        soup_.points.size() + object.vertices.size() > kMaxTriangles)
      throw InvalidInput(file_.path() + ": has more than " + std::to_string(kMaxTriangles) +
                         " triangles or vertices in all");
    const std::size_t base = soup_.points.size();
    for (const Vec3& v : object.vertices) soup_.points.push_back(millimetres * (T_scene_object * v));
    for (const Triangle& t : object.triangles) {
      for (const std::uint32_t v : t)
        soup_.corners.push_back(v < object.vertices.size() ? static_cast<std::uint32_t>(base + v) : kNoIndex);
      soup_.endPolygon();
    }
  }

  const FileBytes& file_;
  ZipArchive archive_;
  const Progress& progress_;
  std::map<std::string, ModelPart> parts_;
  std::size_t placements_ = 0;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup readThreeMfSoup(const FileBytes& file, std::uintmax_t maxUnpacked, const Progress& progress) {
  return ThreeMfReader(file, maxUnpacked, progress).read();
}

}  // namespace vantage
