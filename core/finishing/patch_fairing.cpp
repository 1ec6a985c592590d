#include "finishing/patch_fairing.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vantage {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Entry = Eigen::Triplet<double>;

// Needles and folds have weights without bounds or below zero: these bound them, about those of an even triangle
// (0.58).
constexpr double kLeastWeight = 0.05;
constexpr double kMostWeight = 10.0;

// What an edge from a vertex counts: half the sum of the cotangents of the angles across from it.
struct Spoke {
  std::uint32_t to;
  double weight;
};

struct Weights {
  std::vector<std::vector<Spoke>> spokes;  // per vertex, by `to`
  std::vector<double> area;                // per vertex: a third of its triangles [mm^2]
};

Weights weightsOf(const Mesh& mesh) {
  Weights weights{std::vector<std::vector<Spoke>>(mesh.vertices.size()),
                  std::vector<double>(mesh.vertices.size(), 0.0)};
  for (const Triangle& t : mesh.triangles) {
    const double twice = areaVector(mesh, t).norm();
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[(k + 1) % 3];
      const std::uint32_t b = t[(k + 2) % 3];
      const double cosine = (mesh.vertices[a] - mesh.vertices[t[k]]).dot(mesh.vertices[b] - mesh.vertices[t[k]]);
      const double half = twice > 0.0 ? 0.5 * cosine / twice : kMostWeight;
      weights.spokes[a].push_back({b, half});
      weights.spokes[b].push_back({a, half});
      weights.area[t[k]] += twice / 6.0;
    }
  }
  for (std::vector<Spoke>& spokes : weights.spokes) {
    std::stable_sort(spokes.begin(), spokes.end(), [](const Spoke& x, const Spoke& y) { return x.to < y.to; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      if (kept > 0 && spokes[kept - 1].to == spokes[i].to)
        spokes[kept - 1].weight += spokes[i].weight;
      else
        spokes[kept++] = spokes[i];
    }
    spokes.resize(kept);
    for (Spoke& spoke : spokes) spoke.weight = std::clamp(spoke.weight, kLeastWeight, kMostWeight);
  }
  return weights;
}

// The least-squares equations: every row is a weighted sum of vertices that should be zero.
class Equations {
 public:
  Equations(const FairedPart& part, std::vector<std::int64_t> unknown, Eigen::Index unknowns)
      : part_(part), unknown_(std::move(unknown)), unknowns_(unknowns) {}

  void add(std::uint32_t vertex, double weight) {
    if (unknown_[vertex] >= 0)
      entries_.emplace_back(static_cast<int>(rows_), static_cast<int>(unknown_[vertex]), weight);
    else
      current_ -= weight * part_.mesh.vertices[vertex];
  }
  void endRow() {
    ++rows_;
    right_.push_back(current_);
    current_.setZero();
  }

  // @return the unknown vertices; nothing when the equations leave them open
  [[nodiscard]] std::optional<Eigen::MatrixX3d> solved(const Progress& progress) const {
    Sparse a(rows_, unknowns_);
    a.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::MatrixX3d b(rows_, 3);
    for (Eigen::Index i = 0; i < rows_; ++i) b.row(i) = right_[static_cast<std::size_t>(i)];
    const Sparse normal = a.transpose() * a;
    progress.checkpoint(0.3);
    const Eigen::SimplicialLDLT<Sparse> solver(normal);
    progress.checkpoint(0.8);
    if (solver.info() != Eigen::Success) return std::nullopt;
    Eigen::MatrixX3d x = solver.solve(a.transpose() * b);
    if (solver.info() != Eigen::Success || !x.allFinite()) return std::nullopt;
    return x;
  }

 private:
  const FairedPart& part_;
  std::vector<std::int64_t> unknown_;
  Eigen::Index unknowns_;
  Eigen::Index rows_ = 0;
  std::vector<Entry> entries_;
  std::vector<Vec3> right_;
  Vec3 current_ = Vec3::Zero();
};

}  // namespace

bool fairPatch(FairedPart& part, double reach, const Progress& progress) {
  const std::size_t count = part.mesh.vertices.size();
  std::vector<std::int64_t> unknown(count, -1);
  std::int64_t unknowns = 0;
  for (std::size_t v = 0; v < count; ++v)
    if (part.mayMove[v] != 0) unknown[v] = unknowns++;
  if (unknowns == 0) return true;
  const Weights weights = weightsOf(part.mesh);
  Equations equations(part, unknown, unknowns);
  for (std::uint32_t v = 0; v < count; ++v) {
    if (part.mayMove[v] == 0 && part.onSeam[v] == 0) continue;
    if (reach > 0.0 && weights.area[v] > 0.0) {
      // The square root of reach^2 A |Laplace x|^2, where the Laplacian is the sum of w (x' - x) / A.
      const double plate = reach / std::sqrt(weights.area[v]);
      double sum = 0.0;
      for (const Spoke& spoke : weights.spokes[v]) {
        equations.add(spoke.to, plate * spoke.weight);
        sum += spoke.weight;
      }
      equations.add(v, -plate * sum);
      equations.endRow();
    }
    if (part.mayMove[v] == 0) continue;
    for (const Spoke& spoke : weights.spokes[v]) {
      if (part.mayMove[spoke.to] != 0 && spoke.to < v) continue;  // once per edge
      const double film = std::sqrt(spoke.weight);
      equations.add(v, film);
      equations.add(spoke.to, -film);
      equations.endRow();
    }
  }
  const auto places = equations.solved(progress);
  if (!places) return false;
  for (std::size_t v = 0; v < count; ++v)
    if (unknown[v] >= 0) part.mesh.vertices[v] = places->row(unknown[v]).transpose();
  return true;
}

}  // namespace vantage
