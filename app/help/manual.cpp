#include "help/manual.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <algorithm>

namespace vantage {
namespace {

QString readText(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? QString::fromUtf8(in.readAll()) : QString();
}

std::vector<ManualSection> sectionsOf(const QString& markdown) {
  std::vector<ManualSection> sections;
  bool code = false;
  for (const QString& line : markdown.split(QLatin1Char('\n'))) {
    if (line.startsWith(QLatin1String("```"))) code = !code;
    const QString heading = line.section(QLatin1Char(' '), 1).trimmed();
    if (!code && line.startsWith(QLatin1Char('#')))
      sections.push_back({heading, anchorOf(heading), {}});
    else if (!sections.empty())
      sections.back().text += line + QLatin1Char('\n');
  }
  return sections;
}

// At the begin of a word.
bool hasWord(const QString& text, const QString& word) {
  const QRegularExpression pattern(
      QStringLiteral("(?<![\\w])") + QRegularExpression::escape(word),
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
  return pattern.match(text).hasMatch();
}

bool hasAll(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(), [&](const QString& word) { return hasWord(text, word); });
}

}  // namespace

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower()) {
    if (c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char('-'))
      anchor += c;
    else if (c == QLatin1Char(' '))
      anchor += QLatin1Char('-');
  }
  return anchor;
}

QStringList searchWords(const QString& text) {
  return text.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

Manual::Manual(const QString& folder) {
  const QDir pages(folder);
  const auto add = [&](const QString& title, const QString& name) {
    const QString file = pages.filePath(name);
    const QString text = readText(file);
    if (!text.isEmpty()) pages_.push_back({QString(name).remove(QStringLiteral(".md")), title, file, sectionsOf(text)});
  };
  const QString contents = readText(pages.filePath(QStringLiteral("contents.md")));
  static const QRegularExpression kLink(QStringLiteral("\\[([^\\]]+)\\]\\((\\w+\\.md)\\)"));
  if (contents.isEmpty()) return;
  add(sectionsOf(contents).front().heading, QStringLiteral("contents.md"));
  for (auto link = kLink.globalMatch(contents); link.hasNext();) {
    const auto match = link.next();
    add(match.captured(1), match.captured(2));
  }
}

const ManualPage* Manual::pageOf(const QString& topic) const {
  const QString key = topic.section(QLatin1Char('#'), 0, 0);
  const auto page =
      std::find_if(pages_.begin(), pages_.end(), [&](const ManualPage& candidate) { return candidate.key == key; });
  return page == pages_.end() ? nullptr : &*page;
}

bool Manual::has(const QString& topic) const {
  const ManualPage* page = pageOf(topic);
  const QString anchor = topic.section(QLatin1Char('#'), 1);
  if (page == nullptr || anchor.isEmpty()) return page != nullptr;
  return std::any_of(page->sections.begin(), page->sections.end(),
                     [&](const ManualSection& section) { return section.anchor == anchor; });
}

std::vector<ManualHit> Manual::find(const QString& words) const {
  const QStringList all = searchWords(words);
  std::vector<ManualHit> hits;
  if (all.isEmpty()) return hits;
  for (const bool heading : {true, false})
    for (const ManualPage& page : pages_)
      for (const ManualSection& section : page.sections)
        if (hasAll(section.heading, all) == heading &&
            (heading || hasAll(section.heading + QLatin1Char('\n') + section.text, all)))
          hits.push_back({page.key + QLatin1Char('#') + section.anchor, page.title, section.heading});
  return hits;
}

}  // namespace vantage
