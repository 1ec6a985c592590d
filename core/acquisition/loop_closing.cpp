#include "acquisition/loop_closing.h"

#include <algorithm>

#include "acquisition/hand_placing.h"
#include "acquisition/other_turn.h"
#include "registration/closed_loops.h"
#include "registration/registration_scale.h"

namespace vantage {
namespace {

// Fewer views do not close a loop of their own.
constexpr std::size_t kLeastLoop = 3;

// The views of the model, and what is known of each.
class Loops {
 public:
  Loops(AcquisitionState& state, const std::vector<PreparedView>& prepared, const MultiViewResult& refined,
        const IcpOptions& options)
      : prepared_(prepared), refined_(refined), options_(options) {
    for (KeptScan& scan : state.scans) {
      if (scan.status != ScanStatus::In) continue;
      const RegistrationResult& registration = scan.record.registration;
      scans_.push_back(&scan);
      waits_.push_back(waitsForMore(registration) && turnedByGuess(*scan.view.image) && !isLoose(scan));
      known_.push_back(registration.verdict == Verdict::Good);
    }
  }

  [[nodiscard]] bool anyWaits() const { return std::find(waits_.begin(), waits_.end(), true) != waits_.end(); }

  void close(const Progress& progress) {
    std::vector<bool> wanted;
    for (std::size_t i = 0; i < scans_.size(); ++i) wanted.push_back(waits_[i] || known_[i]);
    groups_ = heldTogether(tiesAmong(prepared_, refined_.poses, wanted, options_, progress), known_);
    const std::vector<std::size_t> sure = largestSure();
    const auto firstKnown = static_cast<std::size_t>(std::find(known_.begin(), known_.end(), true) - known_.begin());
    const std::vector<std::size_t> withKnown = sureOf(0, firstKnown);
    if (sure.size() > withKnown.size() + countKnown() && allTurnedByGuess()) {
      for (std::size_t i = 0; i < scans_.size(); ++i)
        if (known_[i]) doubt(i, sure.front());
      for (const std::size_t i : sure) lift(i, sure.front());
    } else {
      for (const std::size_t i : withKnown) lift(i, firstKnown);
    }
  }

 private:
  [[nodiscard]] std::size_t countKnown() const {
    return static_cast<std::size_t>(std::count(known_.begin(), known_.end(), true));
  }

  // What the operator placed is not put in doubt.
  [[nodiscard]] bool allTurnedByGuess() const {
    return std::all_of(scans_.begin(), scans_.end(),
                       [](const KeptScan* scan) { return turnedByGuess(*scan->view.image) && !takenElsewhere(*scan); });
  }

  [[nodiscard]] double sigma(std::size_t view, std::size_t against) const {
    return refined_.covariance.sigma(view, against, prepared_[view].points, refined_.poses[view]);
  }

  // Of a group, those that are as firm against one view as good ones are.
  [[nodiscard]] std::vector<std::size_t> sureOf(std::size_t group, std::size_t against) const {
    std::vector<std::size_t> sure;
    for (std::size_t i = 0; i < scans_.size(); ++i)
      if (groups_[i] == group && !known_[i] && waits_[i] &&
          sigma(i, against) <= *resolved(options_, scaleOf(prepared_[i].surface)).limits.maxPoseSigma)
        sure.push_back(i);
    return sure;
  }

  // The largest set of views besides the known ones that are held together and sure of the first of them.
  [[nodiscard]] std::vector<std::size_t> largestSure() const {
    std::vector<std::size_t> largest;
    for (std::size_t reference = 0; reference < scans_.size(); ++reference) {
      if (groups_[reference] == 0 || !waits_[reference]) continue;
      std::vector<std::size_t> sure = sureOf(groups_[reference], reference);
      std::stable_partition(sure.begin(), sure.end(), [&](std::size_t i) { return i == reference; });
      if (sure.size() >= kLeastLoop && sure.size() > largest.size()) largest = std::move(sure);
    }
    return largest;
  }

  void lift(std::size_t i, std::size_t against) {
    RegistrationResult& registration = scans_[i]->record.registration;
    registration.verdict = Verdict::Good;
    registration.finding = {VerdictReason::HeldByAll, std::nullopt, {}};
    registration.poseSigma = sigma(i, against);
  }

  void doubt(std::size_t i, std::size_t against) {
    RegistrationResult& registration = scans_[i]->record.registration;
    registration.verdict = Verdict::Doubtful;
    registration.finding = {VerdictReason::HeldByFew, std::nullopt, {}};
    registration.poseSigma = sigma(i, against);
  }

  const std::vector<PreparedView>& prepared_;
  const MultiViewResult& refined_;
  const IcpOptions& options_;
  std::vector<KeptScan*> scans_;
  std::vector<bool> waits_;
  std::vector<bool> known_;
  std::vector<std::size_t> groups_;
};

}  // namespace

bool waitsForMore(const RegistrationResult& registration) {
  if (registration.verdict != Verdict::Doubtful) return false;
  switch (registration.finding.reason) {
    case VerdictReason::HeldByMechanics:
    case VerdictReason::TableAlone:
    case VerdictReason::OnDoubtful:
    case VerdictReason::HeldByFew:
      return true;
    default:
      return false;
  }
}

void liftClosedLoops(AcquisitionState& state, const std::vector<PreparedView>& prepared, const MultiViewResult& refined,
                     const StepOptions& options, const Progress& progress) {
  IcpOptions free = options.registration;
  free.prior.reset();
  Loops loops(state, prepared, refined, free);
  if (loops.anyWaits()) loops.close(progress);
}

}  // namespace vantage
