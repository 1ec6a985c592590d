#include "stand_scanning.h"

#include <utility>

#include "acquisition/stand_course.h"

namespace vantage {
namespace {

class TellingAligner final : public StandAligner {
 public:
  explicit TellingAligner(StandTold tell) : tell_(std::move(tell)) {}

  [[nodiscard]] AlignedStand align(const Composite& object, const Composite& stand, const PickedPairs& picks,
                                   const Progress& progress) const override {
    AlignedStand aligned = usualStandAligner().align(object, stand, picks, progress);
    tell_(stand.views.front().image->station.stand, std::make_shared<const StandAlignment>(aligned.alignment));
    return aligned;
  }

 private:
  StandTold tell_;
};

// Scanning is the first part of a step in a stand that may be aligned after it.
constexpr double kScanPart = 0.6;

}  // namespace

std::shared_ptr<const StandAligner> tellingAligner(StandTold tell) {
  return std::make_shared<const TellingAligner>(std::move(tell));
}

bool scanStand(Acquisition& acquisition, bool untilTheEnd, const std::function<bool()>& pause,
               const Progress& progress) {
  const auto running = [&] { return acquisition.state()->termination == Termination::Running; };
  do {
    if (untilTheEnd)
      acquisition.runUntilTheEnd(progress, [&] { return pause() || mayFindItsPlace(*acquisition.state()); });
    else
      acquisition.scanNext(acquisition.state()->stand() > 0 ? progress.part(0.0, kScanPart) : progress);
    static_cast<void>(findPlaces(acquisition, untilTheEnd ? progress : progress.part(kScanPart, 1.0)));
  } while (untilTheEnd && running() && !pause());
  return !running();
}

}  // namespace vantage
