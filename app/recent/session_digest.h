#pragma once

#include <QDateTime>
#include <QImage>
#include <QString>
#include <string>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// What a list of sessions says of one.
struct SessionDigest {
  Termination termination = Termination::Running;
  int scans = 0;      ///< that are in its model
  QImage picture;     ///< of its model; null without one
  QDateTime changed;  ///< when it was written to last, by its file
};

/// When a session was written to last, as its files say; invalid where there is none.
[[nodiscard]] QDateTime changeOf(const QString& session);

/// Reads a session as far as a list of sessions needs it and draws its model. What came of it is kept in a folder and
/// found there as long as the session does not change. The session stays as it is.
/// @param cacheFolder where that is; empty for nowhere
/// @throws as Session::open; Cancelled
[[nodiscard]] SessionDigest digestOf(const QString& session, const std::string& cacheFolder,
                                     const Progress& progress = {});

/// Forgets what is kept of a session.
void forgetDigest(const QString& session, const std::string& cacheFolder);

/// Its name for people: that of its folder, where the file is called as all are.
[[nodiscard]] QString sessionName(const QString& session);

/// How far it is, in a few words: "finished, 8 scans".
[[nodiscard]] QString progressText(const SessionDigest& digest);

}  // namespace vantage
