#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "acquisition/apply_command.h"
#include "acquisition/journal.h"
#include "acquisition/may_do.h"
#include "acquisition/next_scan.h"
#include "base/progress.h"
#include "positional_space/scanner_images.h"
#include "scanner/rig.h"

namespace vantage {

/// What an acquisition scans and plans with.
struct AcquisitionTools {
  std::optional<Rig> rig;                            ///< open; nothing: nothing is scanned, all else can be done
  std::shared_ptr<const ScannerImages> images;       ///< of the profile; null: nothing is planned
  std::shared_ptr<const StandAligner> aligner = {};  ///< null: stands are aligned as always
};

/// An acquisition: carries out commands, keeps them with what they led to in its journal, scans, plans. Nobody else
/// pairs the two. One thread at a time.
///
/// Whatever fails or is cancelled leaves the acquisition as it was after the last step; a scan that came in meanwhile
/// is kept and used by the next scanNext from its position.
class Acquisition {
 public:
  /// Hears of every step that is done, after it was recorded.
  using StepObserver =
      std::function<void(const Command&, const AcquisitionState& before, const AcquisitionState& after)>;

  /// @param journal must outlive it.
  explicit Acquisition(Journal& journal, AcquisitionTools tools = {}, StepObserver observer = {});

  [[nodiscard]] std::shared_ptr<const AcquisitionState> state() const { return journal_.state(); }
  [[nodiscard]] NextScan next() const { return nextScan(*state()); }

  /// Whether it can be done now: nothing when it can, else why not.
  [[nodiscard]] std::optional<Refusal> mayDo(const Command& command) const { return vantage::mayDo(*state(), command); }
  [[nodiscard]] std::optional<Refusal> mayScan() const;
  [[nodiscard]] std::optional<Refusal> mayUndo() const;
  [[nodiscard]] std::optional<Refusal> mayRedo() const;

  /// Carries out a command and records it. @throws InvalidInput when it may not be done; IoError, Cancelled
  void carryOut(const Command& command, const Progress& progress = {});
  /// Carries it out, but records it only if `keep` wants the state that it leads to. @return whether it did
  bool carryOutIf(const Command& command, const std::function<bool(const AcquisitionState& after)>& keep,
                  const Progress& progress = {});
  void undo();
  void redo();

  /// Keeps a scan that was taken in the stand of now and adds it. @throws as carryOut
  void addScan(RangeImage image, const Progress& progress = {});
  /// Keeps recorded scans and imports them all at once. @throws as carryOut
  /// @param readings as what each of them was read; none where that is not known
  void importScans(std::vector<RangeImage> images, const Progress& progress = {},
                   std::vector<ScanReading> readings = {});

  /// Scans from the position that comes next and adds the scan. Plans first where a plan is needed. Steps reported:
  /// scan, and those of applyCommand.
  /// @throws InvalidInput when nothing can be scanned now (see mayScan); DeviceError, IoError, Cancelled
  void scanNext(const Progress& progress = {});

  /// Scans until nothing is left that a view would show, until a person is needed, or, after a step, until `pause` says
  /// so. @return why it ended; Running when it was paused or waits for a person.
  /// @throws as scanNext; what was recorded before is whole
  Termination runUntilTheEnd(const Progress& progress = {}, const std::function<bool()>& pause = {});

 private:
  void planFirst(const Progress& progress);
  [[nodiscard]] NumberedScan takeScan(int position, const Progress& progress);
  [[nodiscard]] CommandInput input() const;
  void carryOut(const Command& command, const CommandInput& input, const Progress& progress);
  void record(const Command& command, AcquisitionState after);

  Journal& journal_;
  AcquisitionTools tools_;
  StepObserver observer_;
};

}  // namespace vantage
