#include "cli/picture_application.h"

namespace vantage {

PictureApplication::PictureApplication() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  application_.emplace(count_, &arguments_);
}

}  // namespace vantage
