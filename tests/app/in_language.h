#pragma once

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTranslator>
#include <optional>

#include "settings/languages.h"

namespace vantage::testing {

/// A language that nobody speaks: every text with accents and 40 % longer, in words that a line can be broken between.
/// What is no language (keys, patterns of files) stays.
[[nodiscard]] inline QString pseudoText(const QString& text) {
  static const QRegularExpression kKeys(QStringLiteral("^((Ctrl|Alt|Shift)\\+)+\\S+$|^F\\d+$|\\(\\*"));
  if (text.isEmpty() || kKeys.match(text).hasMatch()) return text;
  const QString plain = QStringLiteral("aeiouAEIOU");
  const QString accented = QStringLiteral("áèįöûÀÉĮÖÛ");
  QString changed;
  bool tag = false;
  for (qsizetype i = 0; i < text.size(); ++i) {
    tag = text[i] == u'<' || (tag && text[i] != u'>');
    const bool place = i > 0 && text[i - 1] == u'%';
    const qsizetype k = tag || place ? -1 : plain.indexOf(text[i]);
    changed += k < 0 ? text[i] : accented[k];
  }
  // Behind the last word, before what ends the text.
  qsizetype end = changed.size();
  while (end > 0 && !changed[end - 1].isLetterOrNumber())
    end = changed[end - 1] == u'>' ? changed.lastIndexOf(u'<', end - 1) : end - 1;
  QString more;
  for (qsizetype i = 0; i < (2 * text.size() + 4) / 5; ++i) more += i % 7 == 3 ? u' ' : u'ö';
  return changed.insert(end, more.trimmed());
}

class PseudoTranslator final : public QTranslator {
 public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* /*context*/, const char* text, const char* /*disambiguation*/,
                                  int /*n*/) const override {
    return pseudoText(QString::fromUtf8(text));
  }
};

/// The program in a language of languages(), or in "pseudo", while this lives.
class InLanguage {
 public:
  explicit InLanguage(const QString& code) {
    if (code == QLatin1String("pseudo"))
      QCoreApplication::installTranslator(&pseudo_.emplace());
    else
      translation_.emplace(code);
  }
  ~InLanguage() {
    if (pseudo_) QCoreApplication::removeTranslator(&*pseudo_);
  }
  InLanguage(const InLanguage&) = delete;
  InLanguage& operator=(const InLanguage&) = delete;

 private:
  std::optional<PseudoTranslator> pseudo_;
  std::optional<Translation> translation_;
};

}  // namespace vantage::testing
