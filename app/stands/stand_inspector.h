#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <vector>

#include "acquisition/stand_comparison.h"
#include "job_runner.h"
#include "layers/model_geometry.h"
#include "look/theme.h"

namespace vantage {

/// A stand and the object, ready to be looked at.
struct ComparedStand {
  std::shared_ptr<const StandComparison> comparison;
  std::shared_ptr<const ModelGeometry> object;
  std::shared_ptr<const ModelGeometry> stand;
};

/// A pose as it looks.
struct PoseLook {
  std::shared_ptr<const PosePlaces> places;
  QImage picture;  ///< small, of both over each other
};

/// Makes a stand that is not in place yet ready to be looked at beside the window, and then one after the other all
/// poses that were found. Lives on the UI thread; every call returns at once.
class StandInspector final : public QObject {
  Q_OBJECT

 public:
  explicit StandInspector(JobRunner& jobs, QObject* parent = nullptr);
  ~StandInspector() override;

  /// Nothing is ready any more until loaded or failed.
  void load(const std::shared_ptr<const AcquisitionState>& state, int stand);
  /// Looks at poses of the stand that is ready; those of before are forgotten.
  void lookAt(const std::vector<Pose>& poses, const Theme& theme);
  /// Whether something is being made ready.
  [[nodiscard]] bool busy() const { return loading_ != 0 || looking_ != 0; }
  void stop();

  /// Null parts until it is loaded.
  [[nodiscard]] const ComparedStand& stand() const { return stand_; }
  [[nodiscard]] const std::vector<PoseLook>& looks() const { return looks_; }

 signals:
  void loaded();
  void looked(int pose);
  void ended();  ///< nothing is being made ready any more
  void failed(const QString& why);

 private:
  JobRunner& jobs_;
  ComparedStand stand_;
  std::vector<PoseLook> looks_;
  JobRunner::Id loading_ = 0;
  JobRunner::Id looking_ = 0;
  int question_ = 0;
};

/// Both in a pose, small. @throws Cancelled
[[nodiscard]] QImage posePicture(const StandComparison& comparison, const Pose& T_object_stand,
                                 const PosePlaces& places, const QSize& size, const Theme& theme,
                                 const Progress& progress = {});

}  // namespace vantage
