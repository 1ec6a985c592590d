#include "composites/pose_evidence.h"

#include <span>
#include <vector>

#include "base/parallel.h"
#include "composites/ray_witness.h"
#include "composites/two_sided_fit.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 512;

struct Counts {
  std::size_t conflict = 0;
  std::size_t table = 0;
  std::size_t missing = 0;
};

Counts askSome(RayWitness witness, std::span<const std::uint32_t> points) {
  Counts counts;
  for (const std::uint32_t point : points) {
    const PlaceWord word = witness.ask(point);
    if (word == PlaceWord::Table) ++counts.table;
    if (word == PlaceWord::Conflict) ++counts.conflict;
    if (word == PlaceWord::Missing) ++counts.missing;
  }
  return counts;
}

Counts askAll(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from,
              const AlignmentLimits& limits, const Progress& progress) {
  const RayWitness witness(from, on, T_on_from, limits);
  const std::span<const std::uint32_t> points = from.points(PointLevel::Fine);
  const std::size_t count = points.size();
  std::vector<Counts> chunks(count / kGrain + 1);
  parallelChunks(count, kGrain, progress, [&](std::size_t begin, std::size_t end) {
    chunks[begin / kGrain] = askSome(witness, points.subspan(begin, end - begin));
  });
  Counts all;
  for (const Counts& chunk : chunks) {
    all.conflict += chunk.conflict;
    all.table += chunk.table;
    all.missing += chunk.missing;
  }
  return all;
}

}  // namespace

PoseEvidence evidenceOf(const CompositeModel& reference, const CompositeModel& moved, const Pose& T_reference_moved,
                        const AlignmentLimits& limits, const Progress& progress) {
  const FitQuality fit = TwoSidedFit(reference, moved, PointLevel::Fine, TwoSidedFit::Lookup::Exact, limits.conflict())
                             .quality(T_reference_moved, limits.sampleGate());
  const Counts a = askAll(moved, reference, T_reference_moved, limits, progress.part(0.0, 0.5));
  const Counts b = askAll(reference, moved, T_reference_moved.inverse(), limits, progress.part(0.5, 1.0));
  const auto all =
      static_cast<double>(reference.points(PointLevel::Fine).size() + moved.points(PointLevel::Fine).size());
  PoseEvidence evidence;
  evidence.overlap = fit.overlap;
  evidence.rms = fit.rms;
  evidence.conflict = static_cast<double>(a.conflict + b.conflict) / all;
  evidence.table = static_cast<double>(a.table + b.table) / all;
  evidence.missing = static_cast<double>(a.missing + b.missing) / all;
  return evidence;
}

}  // namespace vantage
