#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>
#include <vector>

namespace vantage {

/// A language of the window.
struct Language {
  QString code;  ///< "de", "zh_CN"
  QString name;  ///< in the language itself: "Deutsch"
};

/// English, and what translations the program brings along, by their codes.
[[nodiscard]] std::vector<Language> languages();

/// The first of the languages that somebody wants, as QLocale::uiLanguages has them ("de-AT"), which the window speaks:
/// a code of languages(). English where it speaks none of them.
[[nodiscard]] QString languageFor(const QStringList& wanted);

/// The program in a language while this lives: the texts of the window and those of Qt, and how numbers are written.
/// Made before the window, by the thread of the application.
class Translation {
 public:
  /// @param code of languages(); empty: what the desktop asks for; any other: English
  explicit Translation(const QString& code);
  ~Translation();
  Translation(const Translation&) = delete;
  Translation& operator=(const Translation&) = delete;

  /// A code of languages().
  [[nodiscard]] const QString& code() const { return code_; }

 private:
  QString code_;
  QLocale before_;
  QTranslator qt_;
  QTranslator window_;
};

}  // namespace vantage
