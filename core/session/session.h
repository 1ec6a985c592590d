#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/journal.h"
#include "base/progress.h"
#include "session/loss.h"

namespace vantage {

/// What a session begins with.
struct SessionStart {
  std::optional<ProfileSource> profile;  ///< none for recorded scans without a scanner
  AcquisitionSettings settings;
  const Mesh* object = nullptr;                             ///< what a simulated scanner looks at, placed
  std::shared_ptr<const ScannerProfile> scanner = nullptr;  ///< what `profile` says; parsed where it is not known yet
};

enum class SessionAccess { Read, Write };

/// A session file that is open: the history of its commands, and the states, scans, models and plans of it, read when
/// they are asked for. Every change is one transaction that is on the disk when the call returns.
///
/// One program at a time may write; it holds a lock file beside the session. Any number may read, also while a run
/// writes: they see the session as it was when they opened it. A damaged session is opened as far as it is readable;
/// for writing it is first copied beside itself. What large pieces nobody holds are not in memory.
///
/// The history changes only by what an Acquisition does, on one thread; everything else may be called from any.
class Session final : public Journal {
 public:
  /// Makes a new session where nothing is yet. @throws IoError, also when something of that name is there or another
  /// program writes to it; what is there stays as it is
  [[nodiscard]] static Session create(const std::string& path, const SessionStart& start);

  /// Opens a session where it was left. One of an earlier version is brought up to date.
  /// @throws IoError when it is missing, no database, or held by another program, which the message names; InvalidInput
  /// when it is not a session or nothing of it is readable; Cancelled
  [[nodiscard]] static Session open(const std::string& path, SessionAccess access, const Progress& progress = {});

  Session(Session&& other) noexcept;
  Session& operator=(Session&& other) noexcept;
  ~Session() override;

  [[nodiscard]] const std::string& path() const;
  /// Everything that was damaged, and the copy that was made of it. What is read later may add to it.
  [[nodiscard]] std::vector<Loss> losses() const;
  /// Reads everything: every row, and the states after all steps that hold. What is not as it was written is in
  /// losses().
  /// @throws Cancelled
  void check(const Progress& progress = {}) const;

  [[nodiscard]] const History& history() const override;
  /// The state at the cursor, and that after any entry of the history.
  [[nodiscard]] std::shared_ptr<const AcquisitionState> state() const override;
  [[nodiscard]] std::shared_ptr<const AcquisitionState> state(std::size_t index) const;

  /// Single pieces, to be shown: the model and the plan that an entry led to (null without), a scan.
  [[nodiscard]] std::shared_ptr<const Model> model(std::size_t index) const;
  [[nodiscard]] std::shared_ptr<const Plan> plan(std::size_t index) const;
  [[nodiscard]] std::int64_t scanCount() const override;
  [[nodiscard]] std::shared_ptr<const RangeImage> scan(std::int64_t number) const override;
  [[nodiscard]] std::optional<NumberedScan> unusedScan() const override;
  [[nodiscard]] std::optional<Station> lastStation() const override;

  [[nodiscard]] std::shared_ptr<const ScannerProfile> profile() const;
  /// What the simulated scanner looks at: as it was kept, else read again from its file.
  /// @throws IoError when the file is gone, InvalidInput when it has changed or the session never had one.
  [[nodiscard]] Mesh object(const Progress& progress = {}) const;

  NumberedScan keepScan(RangeImage image) override;

  /// Remarks of a program, for instance the page that a wizard was on; empty when there is none.
  [[nodiscard]] std::string note(const std::string& key) const;
  void setNote(const std::string& key, const std::string& text);

  /// Waits until the model of the last step is written.
  void settle() const;

  /// Writes the whole session to another file, also when its own was removed. @throws IoError
  void copyTo(const std::string& path) const;

  struct Parts;

 private:
  /// Every step is on the disk when the call returns. Where the file was removed or replaced meanwhile, all of it, with
  /// this command, is in a copy that the message of the IoError names. The model, which can be made again, is written
  /// while the program goes on.
  void record(const Command& command, AcquisitionState state) override;
  void undo() override;
  void redo() override;

  explicit Session(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace vantage
