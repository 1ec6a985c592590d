#include "geometry/ray_caster.h"

#include <embree3/rtcore.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

static_assert(sizeof(OcclusionRay) == sizeof(RTCRay));
static_assert(offsetof(OcclusionRay, directionX) == offsetof(RTCRay, dir_x));
static_assert(offsetof(OcclusionRay, far) == offsetof(RTCRay, tfar));
static_assert(offsetof(OcclusionRay, mask) == offsetof(RTCRay, mask));

// Embree wants denormals flushed for speed; the caller's mode comes back afterwards. Where a machine has no such mode
// that we know of, rays are traced in the caller's.
class FlushDenormals {
 public:
  FlushDenormals() { set(saved_ | 0x8040U); }
  ~FlushDenormals() { set(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE__)
  static unsigned mode() {
    return _mm_getcsr();
  }
  static void set(unsigned mode) {
    _mm_setcsr(mode);
  }
#else
  static unsigned mode() {
    return 0;
  }
  static void set(unsigned /*mode*/) {}
#endif

  unsigned saved_ = mode();
};

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, Release>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

void setPoint(float& x, float& y, float& z, const Vec3& p) {
  x = static_cast<float>(p.x());
  y = static_cast<float>(p.y());
  z = static_cast<float>(p.z());
}

RTCRay makeRay(const Vec3& origin, const Vec3& direction, double near, double far) {
  RTCRay ray{};
  setPoint(ray.org_x, ray.org_y, ray.org_z, origin);
  setPoint(ray.dir_x, ray.dir_y, ray.dir_z, direction);
  ray.tnear = static_cast<float>(near);
  ray.tfar = static_cast<float>(far);
  ray.mask = 0xffffffffU;
  return ray;
}

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
  Device device;
  EmbreeScene scene;

  Scene(const Mesh& source, Precision precision, const Progress& progress) : mesh(source) {
    progress.checkpoint(0.0);
    if (mesh.triangles.size() > 0x7fffffffULL / 3 || mesh.vertices.size() > 0x7fffffffULL)
      throw InvalidInput("mesh of " + std::to_string(mesh.triangles.size()) +
                         " triangles is too large to trace rays in");
    validate(mesh);
    // One build thread: the tree, and with it what a ray that grazes an edge meets, must not depend on the machine.
    device.reset(rtcNewDevice("threads=1,set_affinity=0"));
    scene.reset(rtcNewScene(device.get()));
    if (precision == Precision::Robust) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    if (!mesh.triangles.empty()) attachTriangles();
    progress.checkpoint(0.1);
    Monitor monitor{&progress, false};
    rtcSetSceneProgressMonitorFunction(scene.get(), &Monitor::goOn, &monitor);
    rtcCommitScene(scene.get());
    rtcSetSceneProgressMonitorFunction(scene.get(), nullptr, nullptr);
    if (monitor.stopped) throw Cancelled();
  }

  // How far Embree's single precision may move a point that is as far out as p [mm].
  [[nodiscard]] double rounding(const Vec3& p) const {
    return 1e-6 * std::max(largestCoordinate_, p.cwiseAbs().maxCoeff());
  }

 private:
  // What Embree asks while it builds the tree; no exception may go through it.
  struct Monitor {
    const Progress* progress;
    bool stopped;

    static bool goOn(void* self, double fraction) {
      auto& monitor = *static_cast<Monitor*>(self);
      try {
        monitor.progress->checkpoint(0.1 + 0.9 * fraction);
      } catch (const Cancelled&) {
        monitor.stopped = true;
      }
      return !monitor.stopped;
    }
  };

  void attachTriangles() {
    const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                  RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    if (positions == nullptr || indices == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      setPoint(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], mesh.vertices[i]);
      largestCoordinate_ = std::max(largestCoordinate_, mesh.vertices[i].cwiseAbs().maxCoeff());
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), indices + 3 * i);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene.get(), geometry.get());
  }

  double largestCoordinate_ = 0.0;
};

RayCaster::RayCaster(const Mesh& mesh, Precision precision, const Progress& progress)
    : scene_(std::make_unique<Scene>(mesh, precision, progress)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<RayHit> RayCaster::intersect(const Vec3& origin, const Vec3& direction, double near, double far) const {
  const FlushDenormals mode;
  RTCRayHit query{};
  query.ray = makeRay(origin, direction, near, far);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_->scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  RayHit hit;
  hit.triangle = query.hit.primID;
  hit.normal = triangleNormal(scene_->mesh, scene_->mesh.triangles[hit.triangle]);
  // The plane in double precision is better than the single precision distance, unless the ray runs along it.
  const double slope = direction.dot(hit.normal);
  const double exact =
      (scene_->mesh.vertices[scene_->mesh.triangles[hit.triangle][0]] - origin).dot(hit.normal) / slope;
  const auto rough = static_cast<double>(query.ray.tfar);
  hit.distance = std::abs(slope) > 1e-3 && std::abs(exact - rough) < 1e-3 * (1.0 + rough) ? exact : rough;
  return hit;
}

bool RayCaster::occluded(const Vec3& from, const Vec3& to, double margin) const {
  const Vec3 offset = to - from;
  const double length = offset.norm();
  if (length <= 2.0 * margin) return false;
  const FlushDenormals mode;
  RTCRay ray = makeRay(from, offset / length, margin, length - margin);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_->scene.get(), &context, &ray);
  return ray.tfar < 0.0F;
}

void RayCaster::occluded(std::span<OcclusionRay> rays) const {
  const FlushDenormals mode;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1M(scene_->scene.get(), &context, reinterpret_cast<RTCRay*>(rays.data()),
                static_cast<unsigned>(rays.size()), sizeof(OcclusionRay));
}

std::optional<SurfacePoint> RayCaster::closestPoint(const Vec3& p, double radius) const {
  struct Search {
    const Mesh* mesh;
    Vec3 p;
    double rounding;
    SurfacePoint best;
  } search{&scene_->mesh, p, scene_->rounding(p), {}};
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
    args->query->radius = static_cast<float>(distance * (1.0 + 1e-6) + s.rounding);
    return true;
  };
  RTCPointQuery query{};
  setPoint(query.x, query.y, query.z, p);
  query.radius = static_cast<float>(radius * (1.0 + 1e-6) + search.rounding);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_->scene.get(), &query, &context, visit, &search);
  if (search.best.triangle == kNoIndex) return std::nullopt;
  return search.best;
}

}  // namespace vantage
