#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/next_scan.h"
#include "acquisition/test_turn.h"
#include "job_runner.h"
#include "planning/explanation.h"
#include "report/html_report.h"
#include "scanner/table_turn.h"
#include "session/session.h"
#include "set_up.h"

namespace vantage {

using SharedState = std::shared_ptr<const AcquisitionState>;

/// One moment of a session: what led to it, and what there was.
struct Moment {
  QString text;
  int views = 0;
  int position = -1;      ///< of the scan that led to it; -1 for other commands
  double newArea = 0.0;   ///< that the scan brought [mm^2]
  bool rejected = false;  ///< the scan did not find its place
  bool undone = false;    ///< it is behind the cursor and can be redone
};

/// How an operator turns the table from the last position to another one.
struct TurnAdvice {
  double from = 0.0;  ///< azimuth of the scanner about the object, counter-clockwise from +x [rad]
  double to = 0.0;    ///< the same of the other position [rad]
  TableTurn turn;
};

/// What the controller is busy with.
enum class Activity { Idle, Preparing, Testing, Opening, Running, Pausing, Stopping, Changing, Writing };

/// The one bridge between the engine and the window: holds the set-up and the open session, starts the work on the job
/// runner, and tells by signals what came of it. Knows no widget. Lives on the UI thread; every call returns at once.
class SessionController final : public QObject {
  Q_OBJECT

 public:
  /// @param cacheFolder where images of scanners are kept; empty for nowhere.
  SessionController(JobRunner& jobs, std::string cacheFolder, QObject* parent = nullptr);
  ~SessionController() override;

  [[nodiscard]] Activity activity() const { return activity_; }
  [[nodiscard]] bool idle() const { return activity_ == Activity::Idle; }

  [[nodiscard]] const SetUpChoice& choice() const { return choice_; }
  /// A new choice; what was prepared for another one is dropped. Not while a session is open.
  void setChoice(const SetUpChoice& choice);
  /// Reads profile and object of the choice.
  void prepare();
  [[nodiscard]] const SharedSetUp& setUp() const { return setUp_; }
  void startTestTurn();
  [[nodiscard]] const std::optional<TestTurn>& testTurnResult() const { return testTurn_; }

  [[nodiscard]] bool hasSession() const { return session_ != nullptr; }
  [[nodiscard]] QString sessionPath() const;
  void open(const QString& path);
  /// Leaves the session as it is on the disk.
  void close();

  /// Scans until nothing is left to see. Begins the session when there is none.
  void run();
  /// One scan from the position that comes next, or from another one.
  void step();
  void scanFrom(int position);
  /// Ends a run after the step that is under way.
  void pause();
  /// Ends whatever is under way at once; a step that is not finished leaves no trace.
  void stop();
  /// The position of the next scan; -1 goes back to what the plan proposes.
  void choosePosition(int position);
  void endHere();
  void goOn();
  void leaveOut(std::int64_t scan);
  void takeBack(std::int64_t scan);

  [[nodiscard]] const SharedState& now() const { return now_; }
  [[nodiscard]] NextScan next() const;
  /// From where the last scan was taken (the first position before that); nothing without turntable or position.
  [[nodiscard]] std::optional<TurnAdvice> turnTo(int position) const;
  /// What the plan that holds now says of a position; nothing without a plan.
  [[nodiscard]] std::optional<Explanation> explained(int position) const;
  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }
  [[nodiscard]] int cursor() const { return cursor_; }
  [[nodiscard]] bool canUndo() const { return idle() && cursor_ > 0; }
  [[nodiscard]] bool canRedo() const { return idle() && cursor_ + 1 < static_cast<int>(moments_.size()); }
  void undo();
  void redo();

  /// What the views show: now, or an earlier moment.
  [[nodiscard]] const SharedState& shown() const { return shown_ ? shown_ : now_; }
  [[nodiscard]] int shownMoment() const { return shownMoment_ < 0 ? cursor_ : shownMoment_; }
  [[nodiscard]] bool showsNow() const { return shownMoment_ < 0 || shownMoment_ == cursor_; }
  void showMoment(int index);
  void showNow();

  void exportModel(const QString& path);
  /// What a report on a state shows beside its figures; called beside the window.
  using ReportParts = std::function<HtmlReportOptions(const AcquisitionState&)>;
  void writeReport(const QString& path, ReportParts parts);

  /// The wizard's page, kept in the session so that it reopens there.
  [[nodiscard]] const QString& page() const { return page_; }
  void rememberPage(const QString& page);

 signals:
  void activityChanged();
  void setUpChanged();
  void testTurnChanged();
  void sessionChanged();  ///< opened, begun or closed
  void stateChanged();    ///< now, moments and cursor
  void shownChanged();
  void runEnded();                    ///< an acquisition ended by itself
  void written(const QString& path);  ///< a model or report
  void failed(const QString& what);   ///< one sentence for the operator
  void message(const QString& what);  ///< for the log

 private:
  struct Publication {
    SharedState state;
    std::vector<Moment> moments;
    int cursor = 0;
  };
  using SessionPointer = std::shared_ptr<Session>;

  void setActivity(Activity activity);
  template <typename T>
  void start(Activity activity, const QString& title, std::function<T(const Progress&)> process,
             std::function<void(T)> done);
  void scanInBackground(bool untilTheEnd, std::optional<int> position);
  void change(const Command& command);
  void move(bool backward);
  void adopt(const SessionPointer& session, const SharedSetUp& setUp, const QString& page);
  void publish(Publication publication);
  [[nodiscard]] std::function<void(const Command&, const AcquisitionState&)> recorder(const SessionPointer& session);
  [[nodiscard]] static Publication describe(const Session& session);

  JobRunner& jobs_;
  std::string cacheFolder_;
  SetUpChoice choice_;
  SharedSetUp setUp_;
  std::optional<TestTurn> testTurn_;
  SessionPointer session_;
  Activity activity_ = Activity::Idle;
  JobRunner::Id job_ = 0;
  std::shared_ptr<std::atomic<bool>> pause_;
  SharedState now_;
  SharedState shown_;
  int shownMoment_ = -1;
  std::vector<Moment> moments_;
  int cursor_ = 0;
  QString page_;
};

}  // namespace vantage
