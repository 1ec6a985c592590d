#include "print_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "look/figures.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(PrintText)
};

int asInt(std::size_t count) {
  return static_cast<int>(std::min<std::size_t>(count, 1'000'000'000));
}

QString faultText(PrintFault fault, const PrintCheck& check) {
  switch (fault) {
    case PrintFault::Empty:
      return Text::tr("Nothing of it is left.");
    case PrintFault::Open:
      return Text::tr("It has %n opening(s), the widest %1 mm wide: close them all.", nullptr, asInt(check.openings))
          .arg(figureText(check.widestOpening, 1));
    case PrintFault::NonManifold:
      return Text::tr("%n edge(s) have more than two triangles, or two that face opposite ways.", nullptr,
                      asInt(check.nonManifoldEdges));
    case PrintFault::BowTies:
      return Text::tr("Surfaces only touch in %n place(s).", nullptr, asInt(check.bowTies));
    case PrintFault::Inward:
      return Text::tr("%n piece(s) lie inside out.", nullptr, asInt(check.inwardPieces));
    case PrintFault::Crossings:
      return Text::tr("%n pair(s) of triangles pass through each other.", nullptr, asInt(check.crossings));
    case PrintFault::Pieces:
      break;
  }
  return Text::tr("It is in %n piece(s): leave the loose ones out.", nullptr, asInt(check.pieces));
}

}  // namespace

QString whyNotPrintable(const PrintCheck& check) {
  QStringList lines;
  for (const PrintFault fault : check.faults) lines << faultText(fault, check);
  return lines.join(QLatin1Char('\n'));
}

QString finishingText(const FinishedModel& finished) {
  QStringList lines;
  if (finished.piecesLeftOut > 0)
    lines << Text::tr("%n loose piece(s) left out, %1 mm².", nullptr, asInt(finished.piecesLeftOut))
                 .arg(figureText(finished.areaLeftOut, 1));
  if (!finished.closed.empty())
    lines << Text::tr("%n opening(s) closed: %1 mm² are invented, %2 mm² were measured.", nullptr,
                      asInt(finished.closed.size()))
                 .arg(figureText(finished.inventedArea, 1), figureText(finished.measuredArea, 1));
  if (!finished.left.empty()) lines << Text::tr("%n opening(s) stayed open.", nullptr, asInt(finished.left.size()));
  if (finished.simplified)
    lines << Text::tr("%1 triangles, no farther than %2 mm from the model.")
                 .arg(figureText(static_cast<double>(finished.model.mesh.triangles.size())),
                      figureText(finished.simplified->error.greatest, 3));
  lines << (finished.check.volume ? Text::tr("Closed, %1 cm³.").arg(figureText(*finished.check.volume / 1000.0, 2))
                                  : Text::tr("Not closed: it encloses no volume."));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace vantage
