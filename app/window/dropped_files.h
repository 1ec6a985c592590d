#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>

#include "base/progress.h"

namespace vantage {

/// What was dropped on the window.
enum class DropKind : std::uint8_t {
  Session,  ///< one
  Scans,    ///< range files, and folders of them
  Mesh,     ///< one
  Refused
};

struct Dropped {
  DropKind kind = DropKind::Refused;
  QStringList files;
  QString whyNot;  ///< a sentence that names what cannot be dropped, or not together; of what is refused
};

/// Looks at the beginning of files and into folders: what they are is told by what is in them, not by their names.
/// @throws IoError, InvalidInput naming the file, for one that cannot be read or that nobody knows; Cancelled
[[nodiscard]] Dropped judgeDrop(const QStringList& paths, const Progress& progress = {});

/// What can be dropped on the window, as a sentence.
[[nodiscard]] QString droppableText();

}  // namespace vantage
