#pragma once

#include <QListWidget>
#include <vector>

#include "acquisition/stand_advice.h"

namespace vantage {

/// The sides that an object can rest on as a strip of small pictures, best first; one is chosen.
class StandSides final : public QListWidget {
  Q_OBJECT

 public:
  explicit StandSides(QWidget* parent = nullptr);

  /// Chooses the first.
  void setSides(const std::vector<StandAdvice>& sides);
  /// @param pictures one per side, in their order
  void setPictures(const std::vector<QImage>& pictures);
  [[nodiscard]] int chosen() const { return currentRow(); }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void sideChosen(int side);
};

}  // namespace vantage
