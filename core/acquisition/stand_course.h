#pragma once

#include <optional>
#include <string>

#include "acquisition/acquisition.h"
#include "acquisition/stand_advice.h"

namespace vantage {

/// How an automatic run goes from stand to stand.
struct StandCourse {
  std::optional<int> stands;  ///< how many; nothing: until none would show more than is worth a scan
};

/// Parses "auto" or a number from 1 up. @throws InvalidInput
[[nodiscard]] StandCourse parseStandCourse(const std::string& text);
[[nodiscard]] std::string name(const StandCourse& course);

/// Whether an alignment of the stand of now is worth a try: it is not known yet and has a few views.
[[nodiscard]] bool mayFindItsPlace(const AcquisitionState& state);

/// Tries to align the stand of now and those that were never tried, and tries again those that failed whenever one did
/// not. Where poses leave the same surface, the best is chosen. Where nothing fits the only stand of the object and
/// another shows much more, that one becomes the reference, and the others are tried with it.
/// @param keepFailures also what came of those that cannot be aligned is recorded
/// @return whether the stand of now became known
bool alignStands(Acquisition& acquisition, bool keepFailures, const Progress& progress = {});

/// Whether what would come of an alignment is not known of some stand.
[[nodiscard]] bool hasUntriedStand(const AcquisitionState& state);

/// Aligns stands wherever that is worth a try: after a scan of a stand that is not known yet, and once when it has
/// ended; only then failures are recorded. @return whether anything was tried
bool findPlaces(Acquisition& acquisition, const Progress& progress = {});

/// What another stand has to show at least to be worth it: F of the last plan of the object or of a composite [mm^2].
[[nodiscard]] double leastGain(const AcquisitionState& state);

/// The side that the object is to be put on once the stand of now has ended; nothing when there are stands enough.
[[nodiscard]] std::optional<StandAdvice> nextStand(const AcquisitionState& state, const StandCourse& course,
                                                   const Progress& progress = {});

}  // namespace vantage
