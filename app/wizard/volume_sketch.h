#pragma once

#include <QWidget>

#include "set_up.h"

namespace vantage {

/// The viewing volume and the object in it, from the side and to scale.
class VolumeSketch final : public QWidget {
  Q_OBJECT

 public:
  explicit VolumeSketch(QWidget* parent = nullptr);

  void show(const SharedSetUp& setUp);
  [[nodiscard]] QSize sizeHint() const override { return {280, 190}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  SharedSetUp setUp_;
};

}  // namespace vantage
