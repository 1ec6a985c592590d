#pragma once

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "session_controller.h"
#include "settings/preferences.h"

namespace vantage {

/// What somebody who is to help needs to know of a program, its machine and what it did.
struct Diagnostics {
  std::string version;                                ///< as versionText
  std::vector<std::pair<QString, QString>> machine;   ///< system, processors, memory, display, OpenGL
  std::vector<std::pair<QString, QString>> devices;   ///< what scans and turns, serial ports
  std::vector<std::pair<QString, QString>> settings;  ///< those that are not as they are by default
  QStringList log;                                    ///< the last lines
  QStringList files;                                  ///< names of files and folders that may be in any of these
};

/// Looks at the machine and at what is open. Asks no device, and nothing outside of the machine.
[[nodiscard]] Diagnostics diagnose(const SessionController& controller, const Preferences& preferences,
                                   const QStringList& log);

/// The diagnostics as plain text.
/// @param withFiles whether names of files, folders and the user are told; otherwise they are left out
[[nodiscard]] QString textOf(const Diagnostics& diagnostics, bool withFiles);

/// A text in which <file> stands for every one of some names, and for every other word that looks like the name of a
/// file: it has a slash in it or an ending behind a letter.
[[nodiscard]] QString withoutFiles(QString text, const QStringList& files);

}  // namespace vantage
