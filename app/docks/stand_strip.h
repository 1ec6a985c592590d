#pragma once

#include <QListWidget>
#include <vector>

#include "moments.h"
#include "stand_text.h"

namespace vantage {

/// Moments of the time line that are of the same stand.
struct StandSpan {
  int stand = 0;
  int first = 0;  ///< moment
  int last = 0;   ///< moment
  StandRole role = StandRole::Reference;
  QString sentence;     ///< what came of aligning it
  bool undone = false;  ///< all of it is behind the cursor
};
/// The stands of a session from left to right: each as it is now, or as it was last before it was undone. Empty for an
/// object that was never turned over.
[[nodiscard]] std::vector<StandSpan> standSpans(const std::vector<Moment>& moments, int cursor);

/// A strip above the time line: which moments are of which stand, and what came of that.
class StandStrip final : public QWidget {
  Q_OBJECT

 public:
  /// @param moments whose items it lies above, its parent
  explicit StandStrip(QListWidget& moments);

  void setSpans(std::vector<StandSpan> spans);
  [[nodiscard]] bool isEmpty() const { return spans_.empty(); }
  [[nodiscard]] QString textOf(const StandSpan& span) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRect rectOf(const StandSpan& span) const;

  QListWidget& moments_;
  std::vector<StandSpan> spans_;
};

}  // namespace vantage
