#include "charts/objective_chart.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "charts/axis.h"
#include "charts/objective_key.h"
#include "planning/choice.h"
#include "scanner/table_turn.h"

namespace vantage {
namespace {

constexpr double kLeft = 52.0;
constexpr double kRight = 12.0;
constexpr double kTitle = 30.0;
constexpr double kLine = 16.0;
constexpr double kSmall = 12.0;
constexpr double kGap = 30.0;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ObjectiveView)
};

double share(double value, double most) {
  return most > 0.0 ? std::clamp(value / most, 0.0, 1.0) : 0.0;
}

double mostVoid(const ObjectiveChartData& data) {
  return 1.05 * std::max(data.mostVoid, data.terminationThreshold);
}
double mostOverlap(const ObjectiveChartData& data) {
  return 1.05 * std::max(data.mostOverlap, data.leastOverlap);
}

// "228°", or "228°, 25° up" where the scanner has several heights.
QString placeText(const ObjectiveChartData& data, const ObjectiveChartData::Position& p) {
  const double azimuth = degrees(p.azimuth) < -0.5 ? degrees(p.azimuth) + 360.0 : degrees(p.azimuth);
  const QString text = QString::number(std::lround(azimuth)) + QChar(0x00B0);
  return data.tilts > 1 ? Text::tr("%1, %2° up").arg(text).arg(std::lround(degrees(p.tilt))) : text;
}

// How many wedges the dial has side by side.
std::size_t slotsOf(const ObjectiveChartData& data) {
  return std::max<std::size_t>(data.positions.size(), 1);
}

QString titleOf(const ObjectiveChartData& data) {
  if (data.chosen)
    return (data.operatorsChoice ? Text::tr("Next view, your choice: position %1")
                                 : Text::tr("Next best view: position %1"))
        .arg(*data.chosen);
  return data.further ? Text::tr("Ended; position %1 would be next").arg(*data.further) : Text::tr("No next view");
}

// Title, and what the marked position has.
void paintHead(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const ObjectiveMarks& marks,
               const Theme& theme) {
  const std::optional<int> told = marks.hovered ? marks.hovered : marks.examined ? marks.examined : data.chosen;
  paintOverlay(painter, area, {{titleOf(data)}, {}}, theme);
  if (!told || *told >= static_cast<int>(data.positions.size())) return;
  const auto& p = data.positions[static_cast<std::size_t>(*told)];
  const QString place = Text::tr("position %1, at %2").arg(QString::number(*told), placeText(data, p)) +
                        (p.taken     ? Text::tr(", taken")
                         : p.allowed ? QString()
                                     : Text::tr(", ruled out"));
  const QString areas = Text::tr("would show %1, overlap %2").arg(shortArea(p.voidArea), shortArea(p.overlapArea));
  double top = area.top() + kTitle - 4.0;
  for (const QString& line : {place, areas}) {
    const double needed = QFontMetricsF(pictureFont(kSmall)).horizontalAdvance(line);
    const double pixels = std::floor(kSmall * std::min(1.0, (area.width() - 20.0) / needed));
    paintText(painter, {area.left() + 9.0, top}, Qt::AlignLeft | Qt::AlignTop, line, theme.mutedText, pixels);
    top += kLine;
  }
}

// Around the dial stand the markers, and beyond them the angles [px].
constexpr double kLabelDistance = 22.0;
constexpr double kMarkRoom = 30.0;

// The dial. o_v grows outward from a ring, o_s from the ring inward.
struct Dial {
  QPointF centre;
  double inner;  // where o_s has its most
  double ring;
  double outer;  // where o_v has its most

  explicit Dial(const QRectF& area) {
    const QRectF room = area.adjusted(0.0, kTitle + 2.0 * kLine, 0.0, -kObjectiveKeyHeight);
    centre = room.center();
    outer = std::max(20.0, std::min(0.5 * room.width() - kMarkRoom - 12.0, 0.5 * room.height() - kMarkRoom));
    ring = 0.58 * outer;
    inner = 0.16 * outer;
  }

  [[nodiscard]] double voidRadius(double s) const { return ring + s * (outer - ring); }
  [[nodiscard]] double overlapRadius(double s) const { return ring - s * (ring - inner); }
  [[nodiscard]] QPointF at(double radius, double azimuth) const {
    return centre + radius * QPointF(std::cos(azimuth), -std::sin(azimuth));
  }
  [[nodiscard]] QPolygonF wedge(double from, double to, double azimuth, double halfWidth) const {
    QPolygonF polygon;
    constexpr int kSteps = 3;
    for (int k = 0; k <= kSteps; ++k) polygon << at(from, azimuth - halfWidth + 2.0 * halfWidth * k / kSteps);
    for (int k = kSteps; k >= 0; --k) polygon << at(to, azimuth - halfWidth + 2.0 * halfWidth * k / kSteps);
    return polygon;
  }
};

void paintCircle(QPainter& painter, const Dial& dial, double radius, const QPen& pen) {
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(dial.centre, radius, radius);
}

void paintMarker(QPainter& painter, const Dial& dial, double azimuth, const QColor& colour) {
  const double tip = dial.outer + 2.0;
  QPolygonF arrow;
  arrow << dial.at(tip, azimuth);
  arrow << dial.at(tip, azimuth) + 10.0 * QPointF(std::cos(azimuth + 0.45), -std::sin(azimuth + 0.45));
  arrow << dial.at(tip, azimuth) + 10.0 * QPointF(std::cos(azimuth - 0.45), -std::sin(azimuth - 0.45));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(arrow);
}

void paintDial(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const ObjectiveMarks& marks,
               const Theme& theme) {
  const Dial dial(area);
  for (const double radius : {dial.inner, dial.ring, dial.outer})
    paintCircle(painter, dial, radius, QPen(theme.grid, 1.0));
  const double halfWidth = 0.42 * 2.0 * kPi / static_cast<double>(slotsOf(data));
  painter.setPen(Qt::NoPen);
  for (const auto& p : data.positions) {
    painter.setBrush(objectiveShade(objectiveVoidColour(), p.allowed));
    painter.drawPolygon(
        dial.wedge(dial.ring, dial.voidRadius(share(p.voidArea, mostVoid(data))), p.azimuth + p.aside, halfWidth));
    painter.setBrush(objectiveShade(objectiveOverlapColour(), p.overlapArea > data.leastOverlap));
    painter.drawPolygon(dial.wedge(dial.overlapRadius(share(p.overlapArea, mostOverlap(data))), dial.ring,
                                   p.azimuth + p.aside, halfWidth));
  }
  const QPen dashed(theme.threshold, 1.5, Qt::DashLine);
  paintCircle(painter, dial, dial.voidRadius(share(data.terminationThreshold, mostVoid(data))), dashed);
  paintCircle(painter, dial, dial.overlapRadius(share(data.leastOverlap, mostOverlap(data))),
              QPen(theme.threshold, 1.5, Qt::DotLine));
  for (int degree = 0; degree < 360; degree += 90)
    paintText(painter, dial.at(dial.outer + kLabelDistance, radians(degree)), Qt::AlignHCenter | Qt::AlignVCenter,
              QString::number(degree) + QChar(0x00B0), theme.mutedText);
  const auto mark = [&](std::optional<int> position, const QColor& colour) {
    if (position && *position < static_cast<int>(data.positions.size())) {
      const auto& p = data.positions[static_cast<std::size_t>(*position)];
      paintMarker(painter, dial, p.azimuth + p.aside, colour);
    }
  };
  mark(data.current, theme.current);
  mark(marks.examined, theme.examined);
  mark(data.chosen, theme.proposed);
  mark(marks.hovered, theme.text);
}

// Two rows of bars over one axis of positions.
struct Bars {
  QRectF upper;  // o_v
  QRectF lower;  // o_s
  double step;

  Bars(const QRectF& area, std::size_t count) {
    const QRectF room = area.adjusted(kLeft, kTitle + 34.0, -kRight, -kObjectiveKeyHeight - 20.0);
    const double height = 0.5 * (room.height() - kGap);
    upper = QRectF(room.left(), room.top(), room.width(), height);
    lower = QRectF(room.left(), room.bottom() - height, room.width(), height);
    step = room.width() / static_cast<double>(count);
  }
};

void paintBarAxis(QPainter& painter, const QRectF& box, double most, double threshold, const QString& name,
                  const Theme& theme) {
  painter.setPen(QPen(theme.grid, 1.0));
  painter.drawLine(box.bottomLeft(), box.bottomRight());
  for (const double mark : roundMarks(most, 3)) {
    const double y = box.bottom() - share(mark, most) * box.height();
    painter.setPen(QPen(theme.grid, 0.5));
    painter.drawLine(QPointF(box.left() - 3.0, y), QPointF(box.right(), y));
    paintText(painter, {box.left() - 4.0, y}, Qt::AlignRight | Qt::AlignVCenter, shortNumber(mark), theme.mutedText,
              10.0);
  }
  paintText(painter, box.topLeft() + QPointF(0.0, -2.0), Qt::AlignLeft | Qt::AlignBottom, name, theme.mutedText, 10.0);
  const double y = box.bottom() - share(threshold, most) * box.height();
  painter.setPen(QPen(theme.threshold, 1.5, Qt::DashLine));
  painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
}

void paintBarMarker(QPainter& painter, const Bars& bars, int position, const QColor& colour, const QString& label) {
  const double x = bars.upper.left() + (position + 0.5) * bars.step;
  const double y = bars.upper.bottom() + 4.0;
  QPolygonF arrow;
  arrow << QPointF(x, y) << QPointF(x - 5.0, y + 8.0) << QPointF(x + 5.0, y + 8.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(arrow);
  if (!label.isEmpty()) paintText(painter, {x, y + 7.0}, Qt::AlignHCenter | Qt::AlignTop, label, colour, 10.0, true);
}

void paintPositions(QPainter& painter, const Bars& bars, const ObjectiveChartData& data, const Theme& theme) {
  const int last = static_cast<int>(data.positions.size()) - 1;
  const int most = std::max(1, static_cast<int>(bars.lower.width() / 60.0));
  const auto step =
      static_cast<int>(std::max(1.0, roundMarks(last, most).size() > 1 ? roundMarks(last, most)[1] : 1.0));
  for (int p = 0; p <= last; p += step)
    paintText(painter, {bars.lower.left() + (p + 0.5) * bars.step, bars.lower.bottom() + 2.0},
              Qt::AlignHCenter | Qt::AlignTop, QString::number(p), theme.mutedText, 10.0);
}

void paintBars(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, const ObjectiveMarks& marks,
               const Theme& theme) {
  const Bars bars(area, data.positions.size());
  paintBarAxis(painter, bars.upper, mostVoid(data), data.terminationThreshold, Text::tr("void mm²"), theme);
  paintBarAxis(painter, bars.lower, mostOverlap(data), data.leastOverlap, Text::tr("overlap mm²"), theme);
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    const auto& p = data.positions[i];
    const double x = bars.upper.left() + (static_cast<double>(i) + 0.1) * bars.step;
    const auto bar = [&](const QRectF& box, double s, const QColor& colour) {
      painter.fillRect(QRectF(x, box.bottom() - s * box.height(), 0.8 * bars.step, s * box.height()), colour);
    };
    bar(bars.upper, share(p.voidArea, mostVoid(data)), objectiveShade(objectiveVoidColour(), p.allowed));
    bar(bars.lower, share(p.overlapArea, mostOverlap(data)),
        objectiveShade(objectiveOverlapColour(), p.overlapArea > data.leastOverlap));
  }
  paintPositions(painter, bars, data, theme);
  const auto mark = [&](std::optional<int> position, const QColor& colour, const QString& label) {
    if (position && *position < static_cast<int>(data.positions.size()))
      paintBarMarker(painter, bars, *position, colour, label);
  };
  mark(data.current, theme.current, {});
  mark(marks.examined, theme.examined, {});
  mark(data.chosen, theme.proposed, QString::number(data.chosen.value_or(0)));
  mark(marks.hovered, theme.text, {});
}

}  // namespace

void layTiltsAside(ObjectiveChartData& data) {
  constexpr double kSame = radians(0.1);
  std::vector<std::size_t> order(data.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto azimuth = [&](std::size_t i) {
    const double a = data.positions[i].azimuth;
    return a < -kSame ? a + 2.0 * kPi : a;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return azimuth(a) < azimuth(b); });
  const double slot = 2.0 * kPi / static_cast<double>(slotsOf(data));
  for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
    while (to < order.size() && azimuth(order[to]) - azimuth(order[from]) < kSame) ++to;
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(from), order.begin() + static_cast<std::ptrdiff_t>(to),
              [&](std::size_t a, std::size_t b) { return data.positions[a].tilt < data.positions[b].tilt; });
    const auto count = static_cast<double>(to - from);
    data.tilts = std::max(data.tilts, static_cast<int>(to - from));
    for (std::size_t i = from; i < to; ++i)
      data.positions[order[i]].aside = slot * (static_cast<double>(i - from) - 0.5 * (count - 1.0));
  }
}

ObjectiveChartData objectiveChartData(const ViewSnapshot& snapshot) {
  ObjectiveChartData data;
  data.recorded = snapshot.state && snapshot.state->termination == Termination::Imported;
  if (!snapshot.plan || snapshot.profile() == nullptr) return data;
  const Plan& plan = *snapshot.plan;
  const Workspace& workspace = snapshot.profile()->workspace;
  if (plan.scores.size() != workspace.size()) return data;
  for (const PositionScore& score : plan.scores) {
    ObjectiveChartData::Position position;
    position.azimuth = azimuthOf(*snapshot.profile(), workspace.poses[static_cast<std::size_t>(score.position)]);
    const Vec3 place = scannerPlace(*snapshot.profile(), workspace.poses[static_cast<std::size_t>(score.position)]);
    position.tilt = std::atan2(place.z(), std::hypot(place.x(), place.y()));
    position.voidArea = promise(score);
    position.overlapArea = score.overlapArea;
    position.allowed = score.constraint == Constraint::Chosen || score.constraint == Constraint::Outscored;
    data.mostVoid = std::max(data.mostVoid, position.voidArea);
    data.mostOverlap = std::max(data.mostOverlap, position.overlapArea);
    data.positions.push_back(position);
  }
  for (const View& view : snapshot.views) {
    const std::optional<int> position = view.image->station.position;
    const bool here = view.image->station.stand == snapshot.state->stand() && position &&
                      *position < static_cast<int>(data.positions.size());
    if (here) data.positions[static_cast<std::size_t>(*position)].taken = true;
  }
  data.leastOverlap = plan.leastOverlap;
  data.terminationThreshold = plan.terminationThreshold;
  data.current = snapshot.current();
  data.chosen = snapshot.proposed();
  data.further = snapshot.further;
  data.operatorsChoice = snapshot.operatorsChoice;
  layTiltsAside(data);
  return data;
}

void paintObjective(QPainter& painter, const QRectF& area, const ObjectiveChartData& data, ObjectiveStyle style,
                    const ObjectiveMarks& marks, const Theme& theme) {
  painter.fillRect(area, theme.panel);
  painter.setRenderHint(QPainter::Antialiasing);
  if (data.empty()) {
    const QString why = data.recorded ? Text::tr("Nothing is planned from recorded scans") : Text::tr("No plan yet");
    paintText(painter, area.center(), Qt::AlignHCenter | Qt::AlignVCenter, why, theme.mutedText, 13.0);
    return;
  }
  paintHead(painter, area, data, marks, theme);
  if (style == ObjectiveStyle::Dial)
    paintDial(painter, area, data, marks, theme);
  else
    paintBars(painter, area, data, marks, theme);
  paintObjectiveKey(painter, area, data, theme);
}

std::optional<int> positionAt(const QPointF& point, const QRectF& area, const ObjectiveChartData& data,
                              ObjectiveStyle style) {
  if (data.empty()) return std::nullopt;
  const auto count = static_cast<int>(data.positions.size());
  if (style == ObjectiveStyle::Bars) {
    const Bars bars(area, data.positions.size());
    const QRectF both = bars.upper.united(bars.lower);
    if (!both.contains(point)) return std::nullopt;
    return std::clamp(static_cast<int>((point.x() - both.left()) / bars.step), 0, count - 1);
  }
  const Dial dial(area);
  const QPointF offset = point - dial.centre;
  const double radius = std::hypot(offset.x(), offset.y());
  if (radius < dial.inner || radius > dial.outer + 12.0) return std::nullopt;
  const double azimuth = std::atan2(-offset.y(), offset.x());
  std::optional<int> nearest;
  double least = 4.0;
  for (int i = 0; i < count; ++i) {
    const auto& p = data.positions[static_cast<std::size_t>(i)];
    const double apart = std::abs(std::remainder(p.azimuth + p.aside - azimuth, 2.0 * kPi));
    if (apart < least) {
      least = apart;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace vantage
