#pragma once

#include "settings/field_table.h"

namespace vantage {

/// What an operator sets once, for all sessions.
struct Preferences {
  QString language;    ///< of the window, as languages() has it; empty: as the desktop
  int theme = 0;       ///< light, dark, as the desktop
  int navigation = 4;  ///< NavigationScheme
  int threads = 0;     ///< that a job may use; 0: all of the machine
  bool reopen = true;  ///< the session of last time, if it was not ended
  bool sound = true;   ///< when scanning has ended or waits for somebody
};

[[nodiscard]] FieldTable<Preferences> preferenceFields();

/// From and to the settings file of the user.
[[nodiscard]] Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

}  // namespace vantage
