#pragma once

#include <QWidget>
#include <optional>

#include "views/positional_space_view.h"

class QComboBox;

namespace vantage {

/// Positional space with the choice of the image that is on it.
class PositionalPane final : public QWidget {
  Q_OBJECT

 public:
  PositionalPane(const SurfaceMaker& surfaces, const std::shared_ptr<GeometryStore>& store, QWidget* parent = nullptr);

  [[nodiscard]] PositionalSpaceView& view() { return *view_; }
  /// The position whose image of the scanner is shown; unset for all.
  void setPosition(std::optional<int> position);

 signals:
  void optionsChanged(const vantage::PositionalViewOptions& options);

 private:
  void apply();

  PositionalSpaceView* view_;
  QComboBox* kind_;
  QComboBox* direction_;
  std::optional<int> position_;
};

}  // namespace vantage
