#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

class QTableWidget;

namespace vantage {

/// Range files in the order in which they are used, each with the position that it was taken from, where that is known.
/// Files are added by name, from a folder, or dropped.
class ScanList final : public QWidget {
  Q_OBJECT

 public:
  explicit ScanList(QWidget* parent = nullptr);

  /// How many positions a scan can have been taken from; 0: positions are not asked for.
  void setPositions(int count);
  /// Adds files that are not in the list yet, and those of folders, by name.
  /// @param position that the first of them is taken from, and the others are asked for; nothing: not known
  void addFiles(const QStringList& paths, std::optional<int> position = {});

  [[nodiscard]] std::vector<std::string> files() const;
  [[nodiscard]] std::vector<std::optional<int>> positions() const;

 signals:
  void edited();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void addFile(const QString& path, std::optional<int> position);
  void removeChosen();
  void moveChosen(int by);

  QTableWidget* table_;
  int positionCount_ = 0;
};

/// The range files among paths: files as they are, of folders those with a name that range files have, by name.
[[nodiscard]] QStringList rangeFilesIn(const QStringList& paths);

}  // namespace vantage
