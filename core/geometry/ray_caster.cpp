#include "geometry/ray_caster.h"

#include <embree3/rtcore.h>
#include <xmmintrin.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

static_assert(sizeof(OcclusionRay) == sizeof(RTCRay));
static_assert(offsetof(OcclusionRay, directionX) == offsetof(RTCRay, dir_x));
static_assert(offsetof(OcclusionRay, far) == offsetof(RTCRay, tfar));
static_assert(offsetof(OcclusionRay, mask) == offsetof(RTCRay, mask));

// Embree wants denormals flushed; the caller's mode comes back afterwards.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040U); }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

// Barycentric weights of the point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 closestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double k = 1.0 / (va + vb + vc);
  return {1 - vb * k - vc * k, vb * k, vc * k};
}

}  // namespace

struct RayCaster::Scene {
  Mesh mesh;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Scene(const Mesh& source, Precision precision) : mesh(source) {
    if (mesh.triangles.size() > 0x7fffffffULL / 3 || mesh.vertices.size() > 0x7fffffffULL)
      throw InvalidInput("mesh of " + std::to_string(mesh.triangles.size()) + " triangles is too large to trace rays in");
    for (const Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t)
        if (v >= mesh.vertices.size())
          throw InvalidInput("triangle names vertex " + std::to_string(v) + " of a mesh with " +
                             std::to_string(mesh.vertices.size()) + " vertices");
    // One build thread: the tree, and with it what a ray that grazes an edge meets, must not depend on the machine.
    device = rtcNewDevice("threads=1,set_affinity=0");
    scene = rtcNewScene(device);
    if (precision == Precision::Robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!mesh.triangles.empty()) attachTriangles();
    rtcCommitScene(scene);
  }
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

 private:
  void attachTriangles() {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                  RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   12, mesh.triangles.size()));
    if (positions == nullptr || indices == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      for (int k = 0; k < 3; ++k) positions[3 * i + k] = static_cast<float>(mesh.vertices[i][k]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) indices[3 * i + k] = mesh.triangles[i][k];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

RayCaster::RayCaster(const Mesh& mesh, Precision precision) : scene_(std::make_unique<Scene>(mesh, precision)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<RayHit> RayCaster::intersect(const Vec3& origin, const Vec3& direction, double near, double far) const {
  const FlushDenormals mode;
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x());
  query.ray.org_y = static_cast<float>(origin.y());
  query.ray.org_z = static_cast<float>(origin.z());
  query.ray.dir_x = static_cast<float>(direction.x());
  query.ray.dir_y = static_cast<float>(direction.y());
  query.ray.dir_z = static_cast<float>(direction.z());
  query.ray.tnear = static_cast<float>(near);
  query.ray.tfar = static_cast<float>(far);
  query.ray.mask = 0xffffffffU;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  RayHit hit;
  hit.triangle = query.hit.primID;
  hit.normal = triangleNormal(scene_->mesh, scene_->mesh.triangles[hit.triangle]);
  // The plane in double precision is better than the single precision distance, unless the ray runs along it.
  const double slope = direction.dot(hit.normal);
  const double exact = (scene_->mesh.vertices[scene_->mesh.triangles[hit.triangle][0]] - origin).dot(hit.normal) / slope;
  const auto rough = static_cast<double>(query.ray.tfar);
  hit.distance = std::abs(slope) > 1e-3 && std::abs(exact - rough) < 1e-3 * (1.0 + rough) ? exact : rough;
  return hit;
}

bool RayCaster::occluded(const Vec3& from, const Vec3& to, double margin) const {
  const Vec3 offset = to - from;
  const double length = offset.norm();
  if (length <= 2.0 * margin) return false;
  const FlushDenormals mode;
  RTCRay ray{};
  ray.org_x = static_cast<float>(from.x());
  ray.org_y = static_cast<float>(from.y());
  ray.org_z = static_cast<float>(from.z());
  ray.dir_x = static_cast<float>(offset.x() / length);
  ray.dir_y = static_cast<float>(offset.y() / length);
  ray.dir_z = static_cast<float>(offset.z() / length);
  ray.tnear = static_cast<float>(margin);
  ray.tfar = static_cast<float>(length - margin);
  ray.mask = 0xffffffffU;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_->scene, &context, &ray);
  return ray.tfar < 0.0F;
}

void RayCaster::occluded(std::span<OcclusionRay> rays) const {
  const FlushDenormals mode;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1M(scene_->scene, &context, reinterpret_cast<RTCRay*>(rays.data()), static_cast<unsigned>(rays.size()),
                sizeof(OcclusionRay));
}

std::optional<SurfacePoint> RayCaster::closestPoint(const Vec3& p, double radius) const {
  struct Search {
    const Mesh* mesh;
    Vec3 p;
    SurfacePoint best;
  } search{&scene_->mesh, p, {}};
  search.best.distance = radius;

  auto visit = [](RTCPointQueryFunctionArguments* args) {
    auto& s = *static_cast<Search*>(args->userPtr);
    const Triangle& t = s.mesh->triangles[args->primID];
    const Vec3 &a = s.mesh->vertices[t[0]], &b = s.mesh->vertices[t[1]], &c = s.mesh->vertices[t[2]];
    const Vec3 weights = closestWeights(s.p, a, b, c);
    const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
    const double distance = (point - s.p).norm();
    if (!(distance < s.best.distance || (distance == s.best.distance && args->primID < s.best.triangle))) return false;
    s.best = {point, distance, args->primID, weights};
    args->query->radius = static_cast<float>(distance * (1.0 + 1e-6));
    return true;
  };
  RTCPointQuery query{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0F,
                      static_cast<float>(radius * (1.0 + 1e-6))};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_->scene, &query, &context, visit, &search);
  if (search.best.triangle == kNoIndex) return std::nullopt;
  return search.best;
}

}  // namespace vantage
