#pragma once

#include <QScrollArea>

#include "position_inspector.h"

class QLabel;

namespace vantage {

class FigureTable;
class ScannerPictureView;
struct Theme;

/// Why this view, or why not that one: the card of the position that is asked about, and what the scanner would see
/// from there.
class WhyPanel final : public QScrollArea {
  Q_OBJECT

 public:
  explicit WhyPanel(PositionInspector& inspector, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);

 private:
  void refresh();

  PositionInspector& inspector_;
  QLabel* title_;
  QLabel* verdict_;
  FigureTable* figures_;
  QLabel* sightsTitle_;
  FigureTable* sights_;
  QLabel* comparison_;
  ScannerPictureView* picture_;
};

}  // namespace vantage
