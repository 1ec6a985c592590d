#include "outlook_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "acquisition/views_to_come.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Outlook)
};

// To two digits at most: 7, 20, 45.
int rounded(double value) {
  return value < 10.0 ? std::max(1, static_cast<int>(std::lround(value)))
                      : 5 * static_cast<int>(std::lround(value / 5.0));
}

}  // namespace

QString durationText(double seconds) {
  if (seconds < 90.0) return Text::tr("about %1 s").arg(rounded(seconds));
  if (seconds < 5400.0) return Text::tr("about %1 min").arg(rounded(seconds / 60.0));
  return Text::tr("about %1 h").arg(rounded(seconds / 3600.0));
}

QString outlookText(const AcquisitionState& state) {
  const auto come = viewsToCome(state);
  if (!come) return {};
  const QString views =
      come->views == 1 ? Text::tr("about 1 more view") : Text::tr("about %1 more views").arg(come->views);
  return Text::tr("%1, %2 by an estimate").arg(views, durationText(come->seconds));
}

}  // namespace vantage
