#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace vantage {

/// From a heading of a page to the next one.
struct ManualSection {
  QString heading;
  QString anchor;  ///< the heading as a link names it: "By hand: what to do" is "by-hand-what-to-do"
  QString text;    ///< Markdown, without the heading
};

struct ManualPage {
  QString key;    ///< name of the file without its ending
  QString title;  ///< as the list of contents has it
  QString file;   ///< path
  std::vector<ManualSection> sections;
};

/// Where words were found.
struct ManualHit {
  QString topic;    ///< "page#anchor"
  QString page;     ///< title of the page
  QString heading;  ///< of the section
};

/// The operator's manual: a folder of Markdown pages. contents.md is the first page, and links to the others in their
/// order. Nothing is in a manual whose folder cannot be read.
class Manual {
 public:
  /// @param folder that has contents.md
  explicit Manual(const QString& folder);

  [[nodiscard]] const std::vector<ManualPage>& pages() const { return pages_; }
  /// The page of a topic; null where there is none.
  [[nodiscard]] const ManualPage* pageOf(const QString& topic) const;
  /// Whether page and heading of a topic exist.
  [[nodiscard]] bool has(const QString& topic) const;
  /// Sections that have every one of the words, or begins of them, in heading or text, in any case: those with all of
  /// them in the heading first, then in the order of the pages. None for no words.
  [[nodiscard]] std::vector<ManualHit> find(const QString& words) const;

 private:
  std::vector<ManualPage> pages_;
};

/// As links in Markdown name a heading: lower case, "-" for blanks, without other signs.
[[nodiscard]] QString anchorOf(const QString& heading);

/// The words that a search asks for.
[[nodiscard]] QStringList searchWords(const QString& text);

}  // namespace vantage
