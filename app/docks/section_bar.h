#pragma once

#include <QWidget>
#include <optional>

#include "geometry/measures.h"
#include "layers/section.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace vantage {

/// Where a model is cut: across which axis, where, and which side goes.
class SectionBar final : public QWidget {
  Q_OBJECT

 public:
  explicit SectionBar(QWidget* parent = nullptr);

  /// What there is to cut; the cut stays where it is as far as that is inside.
  void setBox(const BoundingBox& box);
  [[nodiscard]] Section section() const;

 signals:
  void edited();

 private:
  void fitRange(bool toMiddle);
  void slide(int step);
  void place(double at);

  BoundingBox box_;
  bool placed_ = false;  ///< it was somewhere inside of a box
  QComboBox* axis_;
  QSlider* slider_;
  QDoubleSpinBox* at_;
  QCheckBox* flipped_;
};

}  // namespace vantage
