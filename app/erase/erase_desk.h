#pragma once

#include <QObject>
#include <QPolygonF>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "acquisition/erased_regions.h"
#include "job_runner.h"
#include "session_controller.h"
#include "views/model_view.h"

namespace vantage {

/// How the operator says what is to be erased.
enum class EraseTool : std::uint8_t { Lasso, Box, Below, LoosePieces };
inline constexpr int kEraseTools = 4;

/// What an erasure would take out, for the operator.
struct ErasePreview {
  ErasingRegion erasing;
  std::size_t samples = 0;
  std::size_t pieces = 0;
  double area = 0.0;                 ///< [mm^2]
  std::shared_ptr<const Mesh> part;  ///< of the model; null for nothing
};

/// Finds beside the window what a region would take out of the model that is shown, marks it there, and erases it when
/// the operator says so. Lives on the UI thread; every call returns at once.
class EraseDesk final : public QObject {
  Q_OBJECT

 public:
  EraseDesk(SessionController& controller, JobRunner& jobs, ModelView& view, QObject* parent = nullptr);

  /// Why nothing can be erased now; empty when something can.
  [[nodiscard]] QString whyNot() const;

  /// Asks what lies in a line that was drawn on the view.
  /// @param front only what faces the eye, up to the first gap behind it
  void askDrawn(const QPolygonF& corners, bool front);
  /// Asks what lies lower than so far above the table [mm], of what was seen in the stand of now.
  void askBelow(double height);
  /// Asks which pieces hang together with nothing else, up to so large [mm^2].
  void askLoosePieces(double largestArea);
  /// Nothing is asked any more.
  void forget();

  [[nodiscard]] bool asking() const { return job_ != 0; }
  /// The answer; nothing before it is there, or where there is nothing to answer.
  [[nodiscard]] const std::optional<ErasePreview>& preview() const { return preview_; }
  /// Why there is no answer, in a sentence; empty when there is, or nothing was asked.
  [[nodiscard]] const QString& failure() const { return failure_; }
  /// Erases what was asked last. @pre the preview takes something out
  void erase();

 signals:
  void changed();
  void modelChanged();  ///< that is shown: what was drawn on it is no answer any more

 private:
  using Find = std::function<std::optional<ErasingRegion>(const AcquisitionState&)>;
  void ask(Find find);

  SessionController& controller_;
  JobRunner& jobs_;
  ModelView& view_;
  JobRunner::Id job_ = 0;
  int question_ = 0;
  std::optional<ErasePreview> preview_;
  QString failure_;
};

/// The region that a line covers which was drawn on a picture of that size, in the frame that the camera is in.
[[nodiscard]] Prism lassoOf(const QPolygonF& corners, const Camera& camera, const QSizeF& size);

}  // namespace vantage
