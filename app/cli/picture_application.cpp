#include "cli/picture_application.h"

#include <QLocale>

namespace vantage {

PictureApplication::PictureApplication() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  application_.emplace(count_, &arguments_);
  // Reports and pictures are in English, whatever the desktop speaks.
  QLocale::setDefault(QLocale::c());
}

}  // namespace vantage
