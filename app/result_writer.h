#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "hand_over.h"
#include "present.h"
#include "report/html_report.h"
#include "undertaking.h"

namespace vantage {

/// Writes what leaves the program: the model of the object, without stands that are not put together with it yet, as it
/// is or made ready to be handed over, and reports. Lives on the UI thread; every call returns at once.
class ResultWriter final : public QObject {
  Q_OBJECT

 public:
  explicit ResultWriter(Undertaking& work, QObject* parent = nullptr);

  /// @param inUse files that must not be written over
  void exportModel(const SharedState& state, const QString& path, std::vector<std::string> inUse);
  /// The same, finished. What cannot be printed, and should, is not written: printRefused says why.
  void exportFinished(const SharedState& state, const QString& path, const HandOver& how,
                      std::vector<std::string> inUse);
  /// What a report on a state shows beside its figures; called beside the window.
  using ReportParts = std::function<HtmlReportOptions(const AcquisitionState&)>;
  void writeReport(const SharedState& state, const QString& path, ReportParts parts, std::vector<std::string> inUse);

 signals:
  void written(const QString& path);      ///< a model or report
  void madeReady(const QString& what);    ///< what was done to the model that was written
  void printRefused(const QString& why);  ///< a model that cannot be printed was not written

 private:
  Undertaking& work_;
};

}  // namespace vantage
