#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "base/phrase.h"
#include "bench/device_bench.h"
#include "bench/table_calibrating.h"
#include "bench/test_scans.h"
#include "devices/device_factory.h"
#include "job_runner.h"
#include "permissions.h"
#include "present.h"
#include "result_writer.h"
#include "rig_keeper.h"
#include "session/session.h"
#include "session_import.h"
#include "session_keeper.h"
#include "set_up.h"
#include "stand_scanning.h"
#include "turn_advice.h"
#include "undertaking.h"

namespace vantage {

/// The one bridge between the engine and the window: holds the set-up and the open session, starts the work on the job
/// runner, and tells by signals what came of it. Knows no widget. Lives on the UI thread; every call returns at once.
class SessionController final : public QObject {
  Q_OBJECT

 public:
  /// @param cacheFolder where images of scanners are kept; empty for nowhere.
  /// @param devices makes the devices of a set-up.
  SessionController(JobRunner& jobs, std::string cacheFolder, DeviceFactory devices = DeviceFactory(),
                    QObject* parent = nullptr);
  ~SessionController() override;

  /// Where computed pictures are kept between runs; empty for nowhere.
  [[nodiscard]] const std::string& cacheFolder() const { return cacheFolder_; }
  [[nodiscard]] Activity activity() const { return work_.activity(); }
  [[nodiscard]] bool idle() const { return work_.idle(); }
  /// The step that what is under way is at, as it calls it.
  [[nodiscard]] const QString& stepOfWork() const { return work_.step(); }

  [[nodiscard]] const SetUpChoice& choice() const { return choice_; }
  /// A new choice; what was prepared for another one is dropped. Not while a session is open.
  void setChoice(const SetUpChoice& choice);
  /// Reads profile and object of the choice.
  void prepare();
  [[nodiscard]] const SharedSetUp& setUp() const { return setUp_; }
  /// Why the choice could not be read; empty when it was, or was not tried.
  [[nodiscard]] const QString& setUpFailure() const { return setUpFailure_; }
  /// How much memory the scanner of the choice is going to take, known before it is prepared; empty where that is
  /// little.
  [[nodiscard]] const QString& memoryNote() const { return memoryNote_; }
  void testTurn();
  void testScan();
  /// What is cut out of scans from now on; before the first scan.
  void setCut(const CutOptions& cut);
  /// From now on the table turns as that calibration file says; before the first scan.
  void useCalibration(const QString& path);

  /// The devices, scans and calibration of the set-up, before the first scan.
  [[nodiscard]] DeviceBench& bench() { return bench_; }
  [[nodiscard]] TestScans& testScans() { return testScans_; }
  [[nodiscard]] TableCalibrating& calibrating() { return calibrating_; }

  [[nodiscard]] bool hasSession() const { return keeper_.session() != nullptr; }
  [[nodiscard]] QString sessionPath() const { return keeper_.path(); }
  /// Opens another session; the one that is open stays so until that is known to be whole.
  /// @param access Read: it is looked at only, also while another program writes to it
  void open(const QString& path, SessionAccess access = SessionAccess::Write);
  /// Whether the open session may only be looked at.
  [[nodiscard]] bool readOnly() const { return keeper_.readOnly(); }
  /// Makes a session of recorded scans. What is wrong with them is told by importFailed.
  void importScans(const ImportChoice& choice);
  /// Adds scans of files to the open session, each from its position. What is wrong with them is told by importFailed.
  void addScans(const RecordedScans& recorded);
  /// Leaves the session as it is on the disk.
  void close();

  /// Who takes the next step. Kept in the session.
  [[nodiscard]] Mode mode() const { return now() ? now()->mode : mode_; }
  void setMode(Mode mode);

  /// What may be done now. What is called all the same does nothing and says why (see refused).
  [[nodiscard]] Permissions permissions() const;

  /// Scans until nothing is left to see. Begins the session when there is none, opens it again when the operator ended
  /// it.
  void run();
  /// One scan from the position that comes next; begins and opens again like run.
  void step();
  /// What ended the last scan or run, as a sentence; empty when nothing failed, or something else was done since.
  [[nodiscard]] const QString& scanFailure() const { return work_.scanFailure(); }
  /// Whether the next scan is taken whenever the scanner has one, and a person turns the table: run then takes one
  /// after the other.
  [[nodiscard]] bool takesAsTheyCome() const { return permissions().takesAsTheyCome(); }
  /// Whether a person can take the place of the table.
  [[nodiscard]] bool canTurnByHand() const;
  /// From now on a person turns the table.
  void turnByHand();
  /// Ends a run after the step that is under way.
  void pause();
  /// Ends whatever is under way at once; a step that is not finished leaves no trace.
  void stop();
  /// The position of the next scan; nothing goes back to what the plan proposes.
  void choosePosition(std::optional<int> position);
  void endHere();
  /// Carries out a command that needs no scan.
  void change(const Command& command);
  /// Raises the greatest number of views.
  void allowMoreViews(int more);
  void leaveOut(std::int64_t scan);
  void takeBack(std::int64_t scan);
  /// A scan that was refused is taken as from another turn of the table, see TakeAsFrom.
  void takeAsFrom(std::int64_t scan, double tableDeg);

  /// Where the session is now and what comes next: the one place that knows. Also before there is a session.
  [[nodiscard]] const Present& present() const { return present_; }
  [[nodiscard]] const SharedState& now() const { return present_.state(); }
  /// How to turn the table from where it stands; nothing without turntable or position.
  [[nodiscard]] std::optional<TurnAdvice> turnTo(int position) const;
  void undo();
  void redo();
  /// Undoes all that was done after a moment.
  void goBackTo(int moment);

  /// What the views show: now, or an earlier moment.
  [[nodiscard]] const SharedState& shown() const { return shown_ ? shown_ : now(); }
  [[nodiscard]] int shownMoment() const { return shownMoment_.value_or(present_.cursor()); }
  [[nodiscard]] bool showsNow() const { return shownMoment() == present_.cursor(); }
  void showMoment(int index);
  void showNow();

  /// The model of the object: without stands that are not put together with it yet.
  void exportModel(const QString& path);
  /// The same, made ready to be handed over. What cannot be printed, and should, is not written: printRefused says why.
  void exportFinished(const QString& path, const HandOver& how);
  using ReportParts = ResultWriter::ReportParts;
  void writeReport(const QString& path, ReportParts parts);

  /// The wizard's page, kept in the session so that it reopens there.
  [[nodiscard]] const QString& page() const { return keeper_.page(); }
  void rememberPage(const QString& page) { keeper_.rememberPage(page); }

 signals:
  void activityChanged();
  void stepChanged();
  void setUpChanged();
  void sessionChanged();  ///< opened, begun or closed
  void stateChanged();    ///< the present
  void shownChanged();
  /// While scans were taken a stand was aligned, or could not be.
  void standTried(int stand, const std::shared_ptr<const StandAlignment>& alignment);
  void runEnded();                                      ///< an acquisition ended by itself
  void imported();                                      ///< recorded scans are in the session
  void importFailed(const QString& why);                ///< nothing of them is, or not all
  void inUse(const QString& path, const QString& why);  ///< it is not opened: another program writes to it
  void damaged(const QStringList& losses);              ///< what cannot be read of the session that was opened
  void written(const QString& path);                    ///< a model or report
  void madeReady(const QString& what);                  ///< what was done to the model that was written
  void printRefused(const QString& why);                ///< a model that cannot be printed was not written
  void failed(const QString& what);                     ///< one sentence for the operator
  void refused(const QString& why);                     ///< what was asked for cannot be done now
  void message(const QString& what);                    ///< for the log

 private:
  using SessionPointer = SessionKeeper::SessionPointer;

  void changeSetUp(const SharedSetUp& setUp);
  void noteMemory(const Phrase& note);
  void scanInBackground(bool untilTheEnd);
  /// Whether there is nothing to say against; what there is, is said.
  bool allowed(const QString& whyNot);
  /// What must not be written over.
  [[nodiscard]] std::vector<std::string> filesInUse() const;
  void moveTo(int moment, const QString& title);
  void adopt(const OpenedSession& opened, const QString& page);
  void replace(const OpenedSession& opened, const Present& present, const QString& page, bool isImported);
  void publish(Present present);
  [[nodiscard]] Present presentBefore() const;
  [[nodiscard]] StandTold tellOfStand();
  [[nodiscard]] Acquisition::StepObserver publisher(const SessionPointer& session);

  JobRunner& jobs_;
  std::string cacheFolder_;
  std::shared_ptr<RigKeeper> devices_;
  SetUpChoice choice_;
  SharedSetUp setUp_;
  QString setUpFailure_;
  QString memoryNote_;
  Undertaking work_;
  DeviceBench bench_;
  TestScans testScans_;
  TableCalibrating calibrating_;
  SessionKeeper keeper_;
  ResultWriter writer_;
  Mode mode_ = Mode::Automatic;  ///< before there is a session
  Present present_;
  SharedState shown_;
  std::optional<int> shownMoment_;  ///< nothing: now
};

}  // namespace vantage
