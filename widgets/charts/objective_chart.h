#pragma once

#include <QPainter>
#include <cstdint>
#include <optional>
#include <vector>

#include "layers/view_snapshot.h"
#include "look/theme.h"

namespace vantage {

enum class ObjectiveStyle : std::uint8_t {
  Dial,  ///< seen from above like the turntable, x to the right
  Bars,
};

/// What the chart of the objective shows of a plan.
struct ObjectiveChartData {
  struct Position {
    double azimuth = 0.0;      ///< [rad] of where the scanner stands, counter-clockwise from +x
    double tilt = 0.0;         ///< [rad] of where the scanner stands over the table
    double aside = 0.0;        ///< [rad] that the dial shows it beside its azimuth, see layTiltsAside
    double voidArea = 0.0;     ///< what it promises, traced where that is known [mm^2]
    double overlapArea = 0.0;  ///< o_s [mm^2]
    bool allowed = false;      ///< the objective is not 0
    bool taken = false;        ///< a view was taken from there
  };
  std::vector<Position> positions;
  double mostVoid = 0.0;              ///< [mm^2]
  double mostOverlap = 0.0;           ///< [mm^2]
  double leastOverlap = 0.0;          ///< t [mm^2]
  double terminationThreshold = 0.0;  ///< F [mm^2]
  std::optional<int> current;         ///< where the table stands
  std::optional<int> chosen;          ///< the next view
  std::optional<int> further;         ///< what would be next if an acquisition that has ended went on
  bool operatorsChoice = false;       ///< the operator chose the next view
  bool recorded = false;              ///< of recorded scans, for which nothing is planned
  int tilts = 1;                      ///< how many positions there are at most at one azimuth

  [[nodiscard]] bool empty() const { return positions.empty(); }
};

[[nodiscard]] ObjectiveChartData objectiveChartData(const ViewSnapshot& snapshot);

/// Lays positions of one azimuth, which a dial would draw on top of each other, side by side, the lowest first
/// counter-clockwise, and counts them.
void layTiltsAside(ObjectiveChartData& data);

/// What is marked besides the choice.
struct ObjectiveMarks {
  std::optional<int> hovered;
  std::optional<int> examined;
};

void paintObjective(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, ObjectiveStyle style,
                    const ObjectiveMarks& marks, const Theme& theme);

/// The position under a point of the chart painted in that area; unset for none.
[[nodiscard]] std::optional<int> positionAt(const QPointF& point, const QRectF& area, const ObjectiveChartData& data,
                                            ObjectiveStyle style);

}  // namespace vantage
