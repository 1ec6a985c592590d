#include "integration/constrained_delaunay.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

using Edge = std::array<std::uint32_t, 2>;

// Whether the open segments ab and cd cross in one point.
bool cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  return sign(orientation(a, b, c)) * sign(orientation(a, b, d)) < 0 &&
         sign(orientation(c, d, a)) * sign(orientation(c, d, b)) < 0;
}

}  // namespace

ConstrainedDelaunay::ConstrainedDelaunay(std::span<const PlanePoint> points)
    : points_(points.begin(), points.end()),
      infinity_(static_cast<std::uint32_t>(points.size())),
      representative_(points.size()),
      faceOf_(points.size() + 1, kNoIndex),
      faceFrom_(points.size() + 1, kNoIndex) {
  for (const PlanePoint& p : points_)
    if (std::max({p.x, p.y}) > kPlaneLimit || std::min({p.x, p.y}) < -kPlaneLimit)
      throw InvalidInput("point " + std::to_string(p.x) + ", " + std::to_string(p.y) +
                         " is too far out to triangulate");
  std::iota(representative_.begin(), representative_.end(), 0U);
  const std::vector<std::uint32_t> order = insertionOrder();
  std::array<std::uint32_t, 3> first{};
  if (!begin(order, first)) return;
  for (const std::uint32_t point : order)
    if (representative_[point] == point && std::find(first.begin(), first.end(), point) == first.end()) insert(point);
}

// In strips, up and down by turns, so that every point is near the one before. Finds the duplicates.
std::vector<std::uint32_t> ConstrainedDelaunay::insertionOrder() const {
  std::vector<std::uint32_t> order(points_.size());
  std::iota(order.begin(), order.end(), 0U);
  if (points_.empty()) return order;
  const auto [left, right] =
      std::minmax_element(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto strips = static_cast<std::int64_t>(std::sqrt(static_cast<double>(points_.size()) / 2.0)) + 1;
  const std::int64_t width = (static_cast<std::int64_t>(right->x) - left->x) / strips + 1;
  const std::int64_t origin = left->x;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const PlanePoint& a = points_[i];
    const PlanePoint& b = points_[j];
    const std::int64_t stripA = (a.x - origin) / width;
    const std::int64_t stripB = (b.x - origin) / width;
    if (stripA != stripB) return stripA < stripB;
    if (a.y != b.y) return (stripA % 2 == 0) == (a.y < b.y);
    return a.x != b.x ? a.x < b.x : i < j;
  });
  return order;
}

// The first triangle, of the first three points that are not on one line, and the three faces outside of it.
bool ConstrainedDelaunay::begin(const std::vector<std::uint32_t>& order, std::array<std::uint32_t, 3>& first) {
  for (std::size_t i = 1; i < order.size(); ++i)
    if (points_[order[i]] == points_[order[i - 1]]) representative_[order[i]] = representative_[order[i - 1]];
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t point : order) {
    if (representative_[point] != point) continue;
    if (corners.size() == 2 && orientation(points_[corners[0]], points_[corners[1]], points_[point]) == 0) continue;
    corners.push_back(point);
    if (corners.size() == 3) break;
  }
  if (corners.size() < 3) return false;
  if (orientation(points_[corners[0]], points_[corners[1]], points_[corners[2]]) < 0) std::swap(corners[1], corners[2]);
  std::copy(corners.begin(), corners.end(), first.begin());
  const std::uint32_t inner = addFace(first[0], first[1], first[2]);
  std::array<std::uint32_t, 3> outer{};
  for (int k = 0; k < 3; ++k) {
    outer[k] = addFace(first[(k + 1) % 3], first[k], infinity_);
    link({inner, k}, {outer[k], 0});
  }
  for (int k = 0; k < 3; ++k) link({outer[k], 2}, {outer[(k + 1) % 3], 1});
  last_ = inner;
  return true;
}

bool ConstrainedDelaunay::infinite(const Face& face) const {
  return face.vertex[0] == infinity_ || face.vertex[1] == infinity_ || face.vertex[2] == infinity_;
}

bool ConstrainedDelaunay::conflicts(const Face& face, const PlanePoint& p) const {
  for (int k = 0; k < 3; ++k) {
    if (face.vertex[k] != infinity_) continue;
    const PlanePoint& a = points_[face.vertex[(k + 1) % 3]];
    const PlanePoint& b = points_[face.vertex[(k + 2) % 3]];
    const std::int64_t side = orientation(a, b, p);
    return side > 0 || (side == 0 && strictlyBetween(a, b, p));
  }
  return insideCircle(points_[face.vertex[0]], points_[face.vertex[1]], points_[face.vertex[2]], p);
}

// Walks towards p; the walk ends because the triangulation is Delaunay.
std::uint32_t ConstrainedDelaunay::faceInConflict(const PlanePoint& p) const {
  std::uint32_t f = last_;
  for (int k = 0; k < 3; ++k)
    if (faces_[f].vertex[k] == infinity_) {
      f = faces_[f].neighbour[(k + 1) % 3];
      break;
    }
  for (;;) {
    const Face& face = faces_[f];
    if (infinite(face)) return f;
    int exit = -1;
    for (int k = 0; k < 3 && exit < 0; ++k)
      if (orientation(points_[face.vertex[k]], points_[face.vertex[(k + 1) % 3]], p) < 0) exit = k;
    if (exit < 0) return f;
    f = face.neighbour[exit];
  }
}

// Replaces the faces whose circle holds the point by a fan around it.
void ConstrainedDelaunay::insert(std::uint32_t point) {
  const PlanePoint& p = points_[point];
  mark_.resize(faces_.size(), 0);
  ++stamp_;
  std::vector<std::uint32_t> cavity{faceInConflict(p)};
  mark_[cavity[0]] = stamp_;
  struct Rim {
    std::uint32_t from, to;
    Corner outside;
  };
  std::vector<Rim> rim;
  for (std::size_t i = 0; i < cavity.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t next = faces_[cavity[i]].neighbour[k];
      if (mark_[next] == stamp_) continue;
      if (conflicts(faces_[next], p)) {
        mark_[next] = stamp_;
        cavity.push_back(next);
      } else {
        rim.push_back({faces_[cavity[i]].vertex[k], faces_[cavity[i]].vertex[(k + 1) % 3], opposite({cavity[i], k})});
      }
    }
  }
  freeFaces_.insert(freeFaces_.end(), cavity.rbegin(), cavity.rend());
  for (const Rim& edge : rim) {
    const std::uint32_t f = addFace(edge.from, edge.to, point);
    link({f, 0}, edge.outside);
    faceFrom_[edge.from] = f;
    last_ = f;
  }
  for (const Rim& edge : rim) link({faceFrom_[edge.from], 1}, {faceFrom_[edge.to], 2});
}

std::uint32_t ConstrainedDelaunay::addFace(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t f = static_cast<std::uint32_t>(faces_.size());
  if (freeFaces_.empty()) {
    faces_.emplace_back();
  } else {
    f = freeFaces_.back();
    freeFaces_.pop_back();
  }
  faces_[f] = {{a, b, c}, {kNoIndex, kNoIndex, kNoIndex}, {false, false, false}};
  for (const std::uint32_t v : faces_[f].vertex) faceOf_[v] = f;
  return f;
}

void ConstrainedDelaunay::link(Corner a, Corner b) {
  faces_[a.face].neighbour[a.edge] = b.face;
  faces_[b.face].neighbour[b.edge] = a.face;
}

ConstrainedDelaunay::Corner ConstrainedDelaunay::opposite(Corner corner) const {
  const std::uint32_t to = faces_[corner.face].vertex[(corner.edge + 1) % 3];
  const std::uint32_t other = faces_[corner.face].neighbour[corner.edge];
  for (int k = 0; k < 3; ++k)
    if (faces_[other].vertex[k] == to) return {other, k};
  return {other, 0};
}

std::vector<Triangle> ConstrainedDelaunay::triangles() const {
  std::vector<std::uint8_t> unused(faces_.size(), 0);
  for (const std::uint32_t f : freeFaces_) unused[f] = 1;
  std::vector<Triangle> result;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (!unused[f] && !infinite(faces_[f])) result.push_back(faces_[f].vertex);
  return result;
}

// Calls visit(face, edge) for every face at the vertex, edge being the one that leaves it, counter-clockwise, until it
// returns true.
template <typename Visit>
void ConstrainedDelaunay::visitAround(std::uint32_t vertex, const Visit& visit) const {
  const std::uint32_t start = faceOf_[vertex];
  std::uint32_t f = start;
  do {
    int k = 0;
    while (faces_[f].vertex[k] != vertex) ++k;
    if (visit(f, k)) return;
    f = faces_[f].neighbour[(k + 2) % 3];
  } while (f != start);
}

ConstrainedDelaunay::Corner ConstrainedDelaunay::cornerOf(std::uint32_t from, std::uint32_t to) const {
  Corner found{kNoIndex, 0};
  visitAround(from, [&](std::uint32_t f, int k) {
    if (faces_[f].vertex[(k + 1) % 3] != to) return false;
    found = {f, k};
    return true;
  });
  return found;
}

// The edge opposite a that the segment from a to b crosses first; or the point it meets first.
ConstrainedDelaunay::Corner ConstrainedDelaunay::firstCrossing(std::uint32_t a, std::uint32_t b,
                                                               std::uint32_t& through) const {
  Corner found{kNoIndex, 0};
  through = kNoIndex;
  const PlanePoint& pa = points_[a];
  const PlanePoint& pb = points_[b];
  visitAround(a, [&](std::uint32_t f, int k) {
    const std::uint32_t u = faces_[f].vertex[(k + 1) % 3];
    const std::uint32_t w = faces_[f].vertex[(k + 2) % 3];
    for (const std::uint32_t v : {u, w}) {
      if (v == b) through = b;
      if (v == infinity_ || v == b || orientation(pa, pb, points_[v]) != 0) continue;
      if (strictlyBetween(pa, pb, points_[v])) through = v;
    }
    if (through != kNoIndex) return true;
    if (u == infinity_ || w == infinity_) return false;
    if (orientation(pa, points_[u], pb) <= 0 || orientation(pa, points_[w], pb) >= 0) return false;
    found = {f, (k + 1) % 3};
    return true;
  });
  return found;
}

// The edges that the segment from a crosses before it meets a point, `end`, which is b or one on the way.
bool ConstrainedDelaunay::collectCrossings(std::uint32_t a, std::uint32_t b, std::uint32_t& end,
                                           std::vector<Edge>& edges) const {
  edges.clear();
  Corner corner = firstCrossing(a, b, end);
  if (end != kNoIndex) return true;
  while (corner.face != kNoIndex) {
    if (faces_[corner.face].fixed[corner.edge]) return false;
    const Corner next = opposite(corner);
    const Face& face = faces_[next.face];
    edges.push_back({face.vertex[next.edge], face.vertex[(next.edge + 1) % 3]});
    const std::uint32_t apex = face.vertex[(next.edge + 2) % 3];
    const std::int64_t side = orientation(points_[a], points_[b], points_[apex]);
    if (side == 0) {
      end = apex;
      return true;
    }
    // The face's entry edge runs from left to right of the segment.
    corner = {next.face, side > 0 ? (next.edge + 1) % 3 : (next.edge + 2) % 3};
  }
  return false;
}

bool ConstrainedDelaunay::constrain(std::uint32_t a, std::uint32_t b) {
  a = representative_[a];
  b = representative_[b];
  if (a == b || faceOf_[a] == kNoIndex || faceOf_[b] == kNoIndex) return false;
  std::vector<Edge> crossing;
  std::uint32_t end = kNoIndex;
  for (std::uint32_t from = a; from != b; from = end)
    if (!collectCrossings(from, b, end, crossing)) return false;
  for (std::uint32_t from = a; from != b; from = end) {
    if (!collectCrossings(from, b, end, crossing)) return false;
    forceEdge(from, end, crossing);
  }
  return true;
}

void ConstrainedDelaunay::forceEdge(std::uint32_t a, std::uint32_t b, std::vector<Edge> crossing) {
  std::deque<Edge> queue(crossing.begin(), crossing.end());
  std::vector<Edge> fresh;
  while (!queue.empty()) {
    const Edge edge = queue.front();
    queue.pop_front();
    const Corner corner = cornerOf(edge[0], edge[1]);
    if (!flippable(corner)) {
      queue.push_back(edge);
      continue;
    }
    const Corner across = opposite(corner);
    const Edge flipped{faces_[corner.face].vertex[(corner.edge + 2) % 3],
                       faces_[across.face].vertex[(across.edge + 2) % 3]};
    flip(corner);
    if (cross(points_[a], points_[b], points_[flipped[0]], points_[flipped[1]]))
      queue.push_back(flipped);
    else
      fresh.push_back(flipped);
  }
  const Corner corner = cornerOf(a, b);
  const Corner across = opposite(corner);
  faces_[corner.face].fixed[corner.edge] = true;
  faces_[across.face].fixed[across.edge] = true;
  restoreDelaunay(std::move(fresh));
}

// Whether the two faces at the edge form a strictly convex quadrangle.
bool ConstrainedDelaunay::flippable(Corner corner) const {
  const Corner across = opposite(corner);
  const Face& f = faces_[corner.face];
  const Face& g = faces_[across.face];
  if (infinite(f) || infinite(g) || f.fixed[corner.edge]) return false;
  const PlanePoint& a = points_[f.vertex[corner.edge]];
  const PlanePoint& b = points_[f.vertex[(corner.edge + 1) % 3]];
  const PlanePoint& c = points_[f.vertex[(corner.edge + 2) % 3]];
  const PlanePoint& d = points_[g.vertex[(across.edge + 2) % 3]];
  return orientation(c, d, b) > 0 && orientation(c, d, a) < 0;
}

// Replaces the edge ab of faces abc and bad by cd.
void ConstrainedDelaunay::flip(Corner corner) {
  const Corner across = opposite(corner);
  const std::uint32_t f = corner.face;
  const std::uint32_t g = across.face;
  const std::uint32_t a = faces_[f].vertex[corner.edge];
  const std::uint32_t b = faces_[f].vertex[(corner.edge + 1) % 3];
  const std::uint32_t c = faces_[f].vertex[(corner.edge + 2) % 3];
  const std::uint32_t d = faces_[g].vertex[(across.edge + 2) % 3];
  struct Side {
    Corner outside;
    bool fixed;
  };
  const auto side = [&](std::uint32_t face, int edge) {
    return Side{opposite({face, edge}), faces_[face].fixed[edge]};
  };
  const Side bc = side(f, (corner.edge + 1) % 3);
  const Side ca = side(f, (corner.edge + 2) % 3);
  const Side ad = side(g, (across.edge + 1) % 3);
  const Side db = side(g, (across.edge + 2) % 3);
  faces_[f] = {{c, a, d}, {}, {ca.fixed, ad.fixed, false}};
  faces_[g] = {{d, b, c}, {}, {db.fixed, bc.fixed, false}};
  link({f, 0}, ca.outside);
  link({f, 1}, ad.outside);
  link({g, 0}, db.outside);
  link({g, 1}, bc.outside);
  link({f, 2}, {g, 2});
  faceOf_[a] = faceOf_[c] = faceOf_[d] = f;
  faceOf_[b] = g;
}

void ConstrainedDelaunay::restoreDelaunay(std::vector<Edge> edges) {
  while (!edges.empty()) {
    const Edge edge = edges.back();
    edges.pop_back();
    const Corner corner = cornerOf(edge[0], edge[1]);
    if (corner.face == kNoIndex || !flippable(corner)) continue;
    const Corner across = opposite(corner);
    const Face f = faces_[corner.face];
    const Face g = faces_[across.face];
    const std::uint32_t c = f.vertex[(corner.edge + 2) % 3];
    const std::uint32_t d = g.vertex[(across.edge + 2) % 3];
    if (!insideCircle(points_[f.vertex[0]], points_[f.vertex[1]], points_[f.vertex[2]], points_[d])) continue;
    flip(corner);
    for (const std::uint32_t end : edge) {
      edges.push_back({end, c});
      edges.push_back({end, d});
    }
  }
}

}  // namespace vantage
