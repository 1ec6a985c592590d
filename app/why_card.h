#pragma once

#include <QString>
#include <vector>

#include "look/figures.h"
#include "position_inspector.h"

namespace vantage {

/// One line of a card: what is counted, how much, and what it is measured against.
struct WhyFigure {
  QString name;
  QString value;
  QString remark;
};

/// The answer to "why this view", or "why not", in words and figures.
struct WhyCard {
  QString title;                   ///< "Position 42"
  QString verdict;                 ///< one sentence
  std::vector<WhyFigure> figures;  ///< from the plan's record
  std::vector<WhyFigure> sights;   ///< what keeps its patches from sight; empty until it is computed
  QString comparison;              ///< with the choice, or of the choice with the runner-up; empty for none
};

[[nodiscard]] WhyCard makeWhyCard(const PositionInsight& insight);

/// How many there are of something.
[[nodiscard]] QString countText(std::size_t count);
/// An area with its unit.
[[nodiscard]] QString areaText(double squareMillimetres);
[[nodiscard]] QString angleText(double radians);

}  // namespace vantage
