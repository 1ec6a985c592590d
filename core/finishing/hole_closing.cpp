#include "finishing/hole_closing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/errors.h"
#include "finishing/loop_triangulation.h"
#include "finishing/patch_fairing.h"
#include "finishing/patch_refinement.h"
#include "finishing/self_crossings.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// Rounds of turning edges and moving vertices.
constexpr int kFairings = 3;
// Area of an even triangle with edges of length 1.
constexpr double kEvenTriangle = 0.433;

std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

// An opening with what fills it: the vertices of its border first.
struct Lid {
  std::size_t opening;
  double spacing;
  Mesh flat;   // refined, not yet moved
  Mesh shape;  // that it has
  std::size_t crossings = 0;
};

// Makes lids for a surface.
class LidMaker {
 public:
  LidMaker(const Mesh& mesh, const HoleClosingOptions& options) : mesh_(mesh), options_(options), topology_(mesh_) {
    for (const Triangle& t : mesh_.triangles)
      for (int k = 0; k < 3; ++k)
        if (onBorder(t[k]) && onBorder(t[(k + 1) % 3])) borderEdges_.insert(keyOf(t[k], t[(k + 1) % 3]));
  }

  // Nothing when the border cannot be spanned.
  [[nodiscard]] std::optional<Lid> make(const BorderLoop& loop, std::size_t opening, const Progress& progress) const {
    Lid lid{opening, 0.0, spanned(loop, progress.part(0.0, 0.4)), {}};
    if (lid.flat.empty()) return std::nullopt;
    lid.spacing = spacingOf(loop, area(lid.flat));
    refinePatch(lid.flat, lid.spacing, joinedAt(loop), progress.part(0.4, 0.7));
    lid.shape = shaped(loop, lid, options_.reachInEdges, progress.part(0.7, 1.0));
    return lid;
  }

  // A lid that lies as the surface goes on, within so many edges of its border.
  [[nodiscard]] Mesh shaped(const BorderLoop& loop, const Lid& lid, double reachInEdges,
                            const Progress& progress) const {
    Mesh result = lid.flat;
    for (int round = 0; round < kFairings; ++round) {
      const double end = (round + 1.0) / kFairings;
      const Progress fairing = progress.part(static_cast<double>(round) / kFairings, end);
      FairedPart part = withSurroundings(loop, result);
      if (!fairPatch(part, reachInEdges * lid.spacing, fairing)) break;
      std::copy_n(part.mesh.vertices.begin(), result.vertices.size(), result.vertices.begin());
      turnEdges(result, joinedAt(loop), progress.part(end, end));
    }
    return result;
  }

 private:
  [[nodiscard]] bool onBorder(std::uint32_t v) const { return topology_.onBoundary()[v] != 0; }

  // Whether two vertices of a lid are joined by an edge of the surface.
  [[nodiscard]] JoinedOutside joinedAt(const BorderLoop& loop) const {
    return [this, &loop](std::uint32_t a, std::uint32_t b) {
      const std::size_t n = loop.vertices.size();
      return a < n && b < n && borderEdges_.contains(keyOf(loop.vertices[a], loop.vertices[b]));
    };
  }

  // The lid with the vertices of its border first.
  [[nodiscard]] Mesh spanned(const BorderLoop& loop, const Progress& progress) const {
    const std::size_t n = loop.vertices.size();
    Mesh lid;
    for (const std::uint32_t v : loop.vertices) lid.vertices.push_back(mesh_.vertices[v]);
    LoopSurroundings around;
    for (std::size_t i = 0; i < n; ++i)
      around.normals.push_back(normalBeside(loop.vertices[i], loop.vertices[(i + 1) % n]));
    const JoinedOutside joined = joinedAt(loop);
    around.joined = [&](std::size_t a, std::size_t b) {
      return joined(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    };
    lid.triangles = triangulateLoop(lid.vertices, around, progress);
    if (lid.triangles.empty() && n >= 3) fan(lid);
    return lid;
  }

  // From a vertex in the middle, which no edge leads to yet.
  static void fan(Mesh& lid) {
    const auto n = static_cast<std::uint32_t>(lid.vertices.size());
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : lid.vertices) middle += v;
    lid.vertices.emplace_back(middle / n);
    for (std::uint32_t i = 0; i < n; ++i) lid.triangles.push_back({i, (i + 1) % n, n});
  }

  // Of the triangle with the edge from b to a.
  [[nodiscard]] Vec3 normalBeside(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t t : topology_.trianglesOf(a)) {
      const Triangle& corners = mesh_.triangles[t];
      for (int k = 0; k < 3; ++k)
        if (corners[k] == b && corners[(k + 1) % 3] == a) return triangleNormal(mesh_, corners);
    }
    return Vec3::Zero();
  }

  [[nodiscard]] double spacingOf(const BorderLoop& loop, double lidArea) const {
    const double border = loop.length / static_cast<double>(loop.vertices.size());
    const double coarsest = std::sqrt(lidArea / (kEvenTriangle * static_cast<double>(options_.mostTriangles)));
    return std::max({options_.spacing.value_or(border), coarsest, 1e-9 * loop.width, 1e-12});
  }

  // The lid with two rings of the surface around it.
  [[nodiscard]] FairedPart withSurroundings(const BorderLoop& loop, const Mesh& lid) const {
    FairedPart part;
    part.mesh = lid;
    std::unordered_map<std::uint32_t, std::uint32_t> local;
    for (std::uint32_t i = 0; i < loop.vertices.size(); ++i) local[loop.vertices[i]] = i;
    std::vector<std::uint32_t> ring = loop.vertices;
    std::unordered_set<std::uint32_t> taken;
    for (int rings = 0; rings < 2; ++rings) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t v : ring) {
        for (const std::uint32_t t : topology_.trianglesOf(v)) {
          if (!taken.insert(t).second) continue;
          Triangle corners = mesh_.triangles[t];
          for (std::uint32_t& c : corners) {
            const auto [known, isNew] = local.emplace(c, static_cast<std::uint32_t>(part.mesh.vertices.size()));
            if (isNew) {
              part.mesh.vertices.push_back(mesh_.vertices[c]);
              next.push_back(c);
            }
            c = known->second;
          }
          part.mesh.triangles.push_back(corners);
        }
      }
      ring = std::move(next);
    }
    part.mayMove.assign(part.mesh.vertices.size(), 0);
    part.onSeam.assign(part.mesh.vertices.size(), 0);
    for (std::size_t v = 0; v < lid.vertices.size(); ++v)
      (v < loop.vertices.size() ? part.onSeam : part.mayMove)[v] = 1;
    return part;
  }

  const Mesh& mesh_;
  const HoleClosingOptions& options_;
  MeshTopology topology_;  // of the surface without lids
  std::unordered_set<std::uint64_t> borderEdges_;
};

// Appends a lid; the vertices of its border are those of the surface.
void append(Mesh& mesh, const BorderLoop& loop, const Mesh& lid) {
  const auto n = static_cast<std::uint32_t>(loop.vertices.size());
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), lid.vertices.begin() + n, lid.vertices.end());
  for (Triangle t : lid.triangles) {
    for (std::uint32_t& v : t) v = v < n ? loop.vertices[v] : base + v - n;
    mesh.triangles.push_back(t);
  }
}

Mesh withLids(const Mesh& surface, const std::vector<BorderLoop>& loops, const std::vector<Lid>& lids) {
  Mesh mesh = surface;
  for (const Lid& lid : lids) append(mesh, loops[lid.opening], lid.shape);
  return mesh;
}

// Counts where every lid passes through something.
void findCrossings(const Mesh& surface, const std::vector<BorderLoop>& loops, std::vector<Lid>& lids,
                   const Progress& progress) {
  const std::vector<std::size_t> crossings =
      crossingsOf(withLids(surface, loops, lids), static_cast<std::uint32_t>(surface.triangles.size()), progress);
  auto at = crossings.begin();
  for (Lid& lid : lids) {
    const auto end = at + static_cast<std::ptrdiff_t>(lid.shape.triangles.size());
    lid.crossings = std::accumulate(at, end, std::size_t{0});
    at = end;
  }
}

// Draws lids tight that pass through something, where that helps.
void drawTight(const LidMaker& maker, const Mesh& surface, const std::vector<BorderLoop>& loops, std::vector<Lid>& lids,
               const Progress& progress) {
  findCrossings(surface, loops, lids, progress.part(0.0, 0.3));
  std::vector<Lid> tight = lids;
  bool any = false;
  for (Lid& lid : tight) {
    if (lid.crossings == 0) continue;
    lid.shape = maker.shaped(loops[lid.opening], lid, 0.0, progress.part(0.3, 0.6));
    any = true;
  }
  if (!any) return;
  findCrossings(surface, loops, tight, progress.part(0.6, 0.8));
  for (std::size_t i = 0; i < lids.size(); ++i)
    if (tight[i].crossings < lids[i].crossings) lids[i] = std::move(tight[i]);
  findCrossings(surface, loops, lids, progress.part(0.8, 1.0));
}

void checkSurface(const Mesh& mesh) {
  const MeshTopology topology(mesh);
  if (topology.nonManifoldEdges() > 0)
    throw InvalidInput("the surface has " + std::to_string(topology.nonManifoldEdges()) +
                       " edges with more than two triangles, or with two that face opposite ways: its openings cannot "
                       "be told");
}

std::optional<StaysOpen> reasonToStay(const BorderLoop& loop, std::size_t index, const HoleClosingOptions& options) {
  if (options.only && std::find(options.only->begin(), options.only->end(), index) == options.only->end())
    return StaysOpen::NotAsked;
  if (options.maxWidth && loop.width > *options.maxWidth) return StaysOpen::TooWide;
  return std::nullopt;
}

}  // namespace

std::string_view name(StaysOpen reason) {
  switch (reason) {
    case StaysOpen::TooWide:
      return "too_wide";
    case StaysOpen::NotAsked:
      return "not_asked";
    case StaysOpen::NoFilling:
      break;
  }
  return "no_filling";
}

double ClosedMesh::inventedArea() const {
  double sum = 0.0;
  for (const ClosedOpening& opening : closed) sum += opening.area;
  return sum;
}

std::size_t ClosedMesh::crossings() const {
  std::size_t sum = 0;
  for (const ClosedOpening& opening : closed) sum += opening.crossings;
  return sum;
}

ClosedMesh closeHoles(const Mesh& mesh, const HoleClosingOptions& options, const Progress& progress) {
  progress.checkpoint(0.0);
  checkSurface(mesh);
  ClosedMesh result;
  result.firstInventedVertex = static_cast<std::uint32_t>(mesh.vertices.size());
  result.firstInventedTriangle = static_cast<std::uint32_t>(mesh.triangles.size());
  Mesh surface = mesh;
  result.copyOf = splitBowTies(surface);
  const std::vector<BorderLoop> loops = borderLoops(surface);
  const LidMaker maker(surface, options);
  std::vector<Lid> lids;
  const auto share = [&](std::size_t i) { return 0.7 * static_cast<double>(i) / static_cast<double>(loops.size()); };
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::optional<StaysOpen> reason = reasonToStay(loops[i], i, options);
    if (!reason) {
      auto lid = maker.make(loops[i], i, progress.part(share(i), share(i + 1)));
      if (lid)
        lids.push_back(*std::move(lid));
      else
        reason = StaysOpen::NoFilling;
    }
    if (reason) result.left.push_back({i, loops[i].vertices.size(), loops[i].width, *reason});
  }
  if (!lids.empty()) drawTight(maker, surface, loops, lids, progress.part(0.7, 1.0));
  for (const Lid& lid : lids) {
    const BorderLoop& loop = loops[lid.opening];
    result.closed.push_back({lid.opening, loop.vertices.size(), loop.width, area(lid.shape), lid.crossings});
  }
  result.mesh = withLids(surface, loops, lids);
  result.copyOf.resize(result.mesh.vertices.size() - mesh.vertices.size(), kNoIndex);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
