#include "settings/preferences.h"

#include <QCoreApplication>

#include "settings/field_form.h"
#include "settings/languages.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Preferences)
};

}  // namespace

FieldTable<Preferences> preferenceFields() {
  using F = Field<Preferences>;
  QStringList codes{QString()};
  QStringList names{Text::tr("As the desktop")};
  for (const Language& language : languages()) {
    codes << language.code;
    names << language.name;
  }
  return {
      {"language", Text::tr("Language"),
       Text::tr("Of the window, from the next start on. The command line and what is written in files stay English."),
       F::Named{&Preferences::language, codes, names}},
      {"theme", Text::tr("Theme"), Text::tr("Colours of the window and of the views."),
       F::Choice{&Preferences::theme, {Text::tr("Light"), Text::tr("Dark"), Text::tr("As the desktop")}}},
      {"navigation", Text::tr("Mouse"), Text::tr("Which program the mouse buttons in the views follow."),
       F::Choice{&Preferences::navigation,
                 {"MeshLab", "CloudCompare", "Blender", "ParaView", Text::tr("Upright: the table stays level")}}},
      {"threads", Text::tr("Threads"),
       Text::tr("Processors that computing may use from the next start on; 0 takes all. Results never depend on it."),
       F::Whole{&Preferences::threads, 0, 256, {}}},
      {"reopen", Text::tr("Go on where I was"), Text::tr("Open the session of last time at start if it was not ended."),
       F::Switch{&Preferences::reopen}},
      {"sound", Text::tr("Sound"), Text::tr("Sound when scanning has ended or waits for you."),
       F::Switch{&Preferences::sound}}};
}

Preferences loadPreferences() {
  Preferences preferences;
  QSettings file;
  file.beginGroup("preferences");
  readFields(file, preferenceFields(), preferences);
  return preferences;
}

void savePreferences(const Preferences& preferences) {
  QSettings file;
  file.beginGroup("preferences");
  writeFields(file, preferenceFields(), preferences);
  file.endGroup();
  file.sync();
}

}  // namespace vantage
