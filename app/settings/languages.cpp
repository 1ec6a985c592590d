#include "settings/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <algorithm>

// Resources of a static library are there once this was called, outside of every namespace.
static void takeTranslationsIn() {
  Q_INIT_RESOURCE(translations);
}

namespace vantage {
namespace {

constexpr QLatin1String kFolder(":/translations");
constexpr QLatin1String kEnglish("en");

// "Deutsch", "简体中文".
QString nameIn(const QString& code) {
  QString name = QLocale(code).nativeLanguageName();
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

bool areTheSame(const QLocale& a, const QLocale& b) {
  return a.language() == b.language() && a.script() == b.script();
}

// Numbers as the desktop has them where it speaks the language too.
QLocale localeOf(const QString& code) {
  const QLocale desktop = QLocale::system();
  return areTheSame(desktop, QLocale(code)) ? desktop : QLocale(code);
}

}  // namespace

std::vector<Language> languages() {
  takeTranslationsIn();
  std::vector<Language> all{{kEnglish, QStringLiteral("English")}};
  for (const QString& file : QDir(kFolder).entryList({QStringLiteral("vantage_*.qm")}, QDir::Files, QDir::Name)) {
    const QString code = file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    all.push_back({code, nameIn(code)});
  }
  return all;
}

QString languageFor(const QStringList& wanted) {
  const std::vector<Language> known = languages();
  for (const QString& want : wanted) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Language& l) { return areTheSame(QLocale(want), QLocale(l.code)); });
    if (found != known.end()) return found->code;
  }
  return kEnglish;
}

Translation::Translation(const QString& code) : code_(kEnglish) {
  const std::vector<Language> known = languages();
  if (code.isEmpty())
    code_ = languageFor(QLocale::system().uiLanguages());
  else if (std::any_of(known.begin(), known.end(), [&](const Language& l) { return l.code == code; }))
    code_ = code;
  QLocale::setDefault(localeOf(code_));
  if (code_ == kEnglish) return;
  if (qt_.load(QStringLiteral("qtbase_") + code_, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_);
  if (window_.load(QStringLiteral("vantage_") + code_, kFolder)) QCoreApplication::installTranslator(&window_);
}

Translation::~Translation() {
  QCoreApplication::removeTranslator(&window_);
  QCoreApplication::removeTranslator(&qt_);
  QLocale::setDefault(before_);
}

}  // namespace vantage
