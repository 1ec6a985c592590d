#include "composites/pose_places.h"

#include "base/parallel.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 512;

std::vector<PlaceWord> wordsOf(const CompositeModel& from, const CompositeModel& on, const Pose& T_on_from,
                               const AlignmentLimits& limits, const Progress& progress) {
  const RayWitness witness(from, on, T_on_from, limits);
  std::vector<PlaceWord> words(from.surface().size(), PlaceWord::Nothing);
  parallelChunks(words.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    RayWitness own = witness;
    for (std::size_t v = begin; v < end; ++v) {
      const auto point = static_cast<std::uint32_t>(v);
      words[v] = own.ask(point);
      if (words[v] == PlaceWord::OnIt && !own.agrees(point, limits.sampleGate())) words[v] = PlaceWord::Nothing;
    }
  });
  return words;
}

}  // namespace

PosePlaces placesAt(const CompositeModel& reference, const CompositeModel& moved, const Pose& T_reference_moved,
                    const AlignmentLimits& limits, const Progress& progress) {
  return {wordsOf(reference, moved, T_reference_moved.inverse(), limits, progress.part(0.0, 0.5)),
          wordsOf(moved, reference, T_reference_moved, limits, progress.part(0.5, 1.0))};
}

}  // namespace vantage
