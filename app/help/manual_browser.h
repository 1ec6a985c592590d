#pragma once

#include <QTextBrowser>

namespace vantage {

/// Shows pages of the manual, which are Markdown: headings can be linked to, tables have lines, pictures are no wider
/// than a column that is read well, and words that were searched for are marked.
class ManualBrowser final : public QTextBrowser {
  Q_OBJECT

 public:
  explicit ManualBrowser(QWidget* parent = nullptr);

  /// Marks them in this page and in those that are shown from now on; none ends that.
  void markWords(const QStringList& words);
  /// Selects the next place of any of the marked words, from the top again after the last one.
  /// @return whether there is any
  bool findNext(bool backwards = false);

 private:
  void dress(const QUrl& page);
  void mark();

  QStringList words_;
};

}  // namespace vantage
