#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "acquisition/stand_course.h"
#include "cli/acquisition_results.h"
#include "cli/command.h"
#include "cli/person_at_table.h"
#include "devices/device_factory.h"
#include "session/session.h"

namespace vantage {

/// A run of a session by itself: says what every scan brought, writes report.json, model.ply and model.stl at the end,
/// also when it is cancelled, unless the model is so large that this would take its time.
class SessionRun {
 public:
  /// @param out folder for the results, which exists; what is there may be replaced. All must outlive it.
  /// @param course how it goes from stand to stand; nothing: the stand of now is all
  /// @param positions scans are taken from these and no others, in order, whatever the plan says; empty: as is planned
  SessionRun(Session& session, std::string out, CommandContext& context, std::optional<StandCourse> course = {},
             std::vector<int> positions = {});

  /// @param person who turns the table, when one does; who tells a program what goes on
  /// @throws InvalidInput, IoError, DeviceError, Cancelled: the session can be resumed
  void run(const DeviceSetUp& devices, PersonAtTable* person = nullptr);

 private:
  using SharedImages = std::shared_ptr<const ScannerImages>;

  void acquireAll(const DeviceSetUp& devices, PersonAtTable* person);
  void acquireStand(const DeviceSetUp& devices, const SharedImages& images, PersonAtTable* person);
  bool goOn(Acquisition& acquisition, std::set<int>& skipped, PersonAtTable* person);
  void scanFromPositions(Acquisition& acquisition);
  [[nodiscard]] bool turnOver(const SharedImages& images);
  [[nodiscard]] Acquisition::StepObserver observer(PersonAtTable* person);
  void tellLast(PersonAtTable* person);
  void takeLast(Acquisition& acquisition, PersonAtTable& person);
  void writeResults();
  void writeStopped();
  void announce();

  Session& session_;
  AcquisitionResults results_;
  CommandContext& context_;
  std::optional<StandCourse> course_;
  std::vector<int> positions_;
  std::shared_ptr<const AcquisitionState> last_;
  nlohmann::ordered_json report_;
};

/// What became of the scan that was added last, in a line: what it brought, or why it was not integrated.
[[nodiscard]] std::string lastScanLine(const AcquisitionState& state);

/// What came of the alignment of a stand, in a line.
[[nodiscard]] std::string standLine(const AcquisitionState& state, int stand);

/// Lets a session go on with other settings, which is recorded like every command; nothing happens when they are equal.
/// @throws InvalidInput, IoError, Cancelled
void changeSettings(Session& session, const AcquisitionSettings& settings, CommandContext& context);

/// Says how much memory a scanner of very many rays takes before any of the work on it begins.
/// @param scans that the session has already
void tellMemoryNeeded(std::size_t rays, const AcquisitionSettings& settings, std::size_t scans,
                      CommandContext& context);

}  // namespace vantage
