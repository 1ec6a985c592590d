#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "acquisition/stand_advice.h"
#include "layers/model_geometry.h"
#include "session_controller.h"

namespace vantage {

/// What is known of the sides that the object may be put on next.
struct StandProspect {
  StandOutlook outlook;
  double leastGain = 0.0;                         ///< what a side has to show at least to be worth a stand [mm^2]
  double known = 0.0;                             ///< area of the model [mm^2]
  std::shared_ptr<const ModelGeometry> geometry;  ///< of the object; null without a model
  std::shared_ptr<const ScannerProfile> profile;

  /// Whether another stand is worth it, by the best side.
  [[nodiscard]] bool worthAnother() const;
};

/// Everything about stands that the window does: finds sides to put the object on, turns it over, aligns, goes back.
/// Lives on the UI thread; every call returns at once.
class StandDesk final : public QObject {
  Q_OBJECT

 public:
  StandDesk(SessionController& controller, JobRunner& jobs, QObject* parent = nullptr);

  /// Computes beside the window what there is to know of the sides now, unless that is known, under way, or something
  /// else is.
  void look();
  void stopLooking();
  [[nodiscard]] bool looking() const { return looking_; }
  /// Of the state of now; null while it is not known.
  [[nodiscard]] const std::shared_ptr<const StandProspect>& prospect() const { return prospect_; }
  /// Why it could not be found out, as a sentence; empty when nothing failed.
  [[nodiscard]] const QString& failure() const { return failure_; }

  [[nodiscard]] QString whyNotTurn() const;
  /// The object was put on about that side.
  void turnOnto(const Vec3& down);

  /// The stand of now.
  [[nodiscard]] int stand() const;
  /// Whether it is not known yet how the object stands.
  [[nodiscard]] bool isOpen() const;
  /// Whether it was tried to find that out, in vain.
  [[nodiscard]] bool failedToAlign() const { return isOpen() && (tried_ || recorded_); }
  /// How it stands with the stand of now, as a sentence; empty for the first one.
  [[nodiscard]] QString sentence() const;

  [[nodiscard]] QString whyNotAlign() const;
  void align();
  [[nodiscard]] QString whyNotGoBack() const;
  /// Undoes all that was done since the object was turned over last.
  void goBack();

 signals:
  void prospectChanged();
  void sentenceChanged();
  void turned();            ///< a stand was begun
  void comparisonWanted();  ///< the operator asks to see how the stand of now may lie in the object

 private:
  void refresh();
  void forget();
  void finish(JobResult<std::shared_ptr<const StandProspect>> result);
  /// The moment before the last stand began; nothing in the first one.
  [[nodiscard]] std::optional<int> momentBefore() const;

  SessionController& controller_;
  JobRunner& jobs_;
  SharedState state_;  // that was looked at, or is
  bool looking_ = false;
  JobRunner::Id job_ = 0;
  int question_ = 0;
  std::shared_ptr<const StandProspect> prospect_;
  QString failure_;
  std::shared_ptr<const StandAlignment> tried_;  // of the stand of now, not recorded
  std::shared_ptr<const StandAlignment> recorded_;
  int standBefore_ = 0;
  bool turning_ = false;
};

}  // namespace vantage
