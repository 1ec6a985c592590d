#pragma once

#include "charts/objective_chart.h"

namespace vantage {

inline constexpr double kObjectiveKeyHeight = 57.0;  ///< [px]

[[nodiscard]] QColor objectiveVoidColour();
[[nodiscard]] QColor objectiveOverlapColour();
/// Positions that the objective rules out keep their place, but step back.
[[nodiscard]] QColor objectiveShade(QColor colour, bool allowed);

/// "4 492 mm²".
[[nodiscard]] QString shortArea(double squareMillimetres);

/// What colours, lines and arrows of the objective stand for, along the lower border.
void paintObjectiveKey(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const Theme& theme);

}  // namespace vantage
