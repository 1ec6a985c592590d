#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/serial/serial_line.h"
#include "devices/serial/table_dialog.h"
#include "devices/serial/table_motion.h"
#include "devices/serial/table_profile.h"

namespace vantage {

/// A turntable on a serial line, whatever firmware it has: a profile tells how to speak with it.
///
/// It counts from where it stood when it was opened, or from where home was last called. Where it stands is known until
/// something says otherwise: a restart, an alarm, silence, a report of another place. Then it turns no more until home.
///
/// identity, notReady, angle, status and stop may be called from any thread at any time.
class SerialTurntable final : public Turntable {
 public:
  /// @param profiles that it may answer to; several: found by asking. @throws InvalidInput when there is none
  SerialTurntable(std::unique_ptr<SerialLine> line, std::vector<TableProfile> profiles);
  ~SerialTurntable() override;

  [[nodiscard]] std::string identity() const override;
  void open(const Progress& progress) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& progress) override;
  [[nodiscard]] std::optional<TableAngle> angle() const override { return status().angle; }
  /// Looks for its index where the board has one, and begins to count where it then stands.
  void home(const Progress& progress) override;

  /// An alarm is cleared first.
  std::optional<TableAngle> jog(double degrees, const Progress& progress) override;
  void ask(const Progress& progress) override { askStatus(progress); }

  /// Stops what it does: that ends as cancelled.
  void stop() noexcept { stopAsked_ = true; }

  /// As known last, at once.
  [[nodiscard]] TableStatus status() const;
  /// As the table says now. @throws DeviceError, Cancelled
  TableStatus askStatus(const Progress& progress);

  /// Name of the profile that it answers to; empty before it was opened.
  [[nodiscard]] std::string protocol() const;
  /// Its title, likewise.
  [[nodiscard]] std::string title() const;

 private:
  // What other threads ask for.
  struct Known {
    TableState state = TableState::Closed;
    std::optional<double> position;   // [units]
    std::optional<std::string> lost;  // why the position is not that of the table
    std::string identity, protocol, title;
  };

  void guarded(const Progress& progress, const std::function<void(const TableDialog::Pulse&)>& work);
  [[nodiscard]] TableDialog::Pulse pulseOf(const Progress& progress) const;

  void connect(const TableDialog::Pulse& pulse);
  void beginTalking(const TableDialog::Pulse& pulse);
  void readSettings(const TableDialog::Pulse& pulse);
  void makeReady(const TableDialog::Pulse& pulse);
  void unlock(StatusReport& report, const TableDialog::Pulse& pulse);
  void findIndex(const TableDialog::Pulse& pulse);
  void countFromHere(const TableDialog::Pulse& pulse);

  void needOpen() const;
  void needPosition() const;
  void finishStop(const TableDialog::Pulse& pulse);
  void checkStillThere(const TableDialog::Pulse& pulse);
  void turn(double units, const Progress& progress);
  void afterCancel() noexcept;
  void afterShortMove();
  void afterLoss(const std::string& why, const TableDialog::Pulse& pulse) noexcept;
  void afterRefusal(const TableDialog::Pulse& pulse) noexcept;

  [[nodiscard]] StatusReport report(const TableDialog::Pulse& pulse);
  [[nodiscard]] TableAngle angleAt(double units) const;
  [[nodiscard]] double unitsOf(double degrees) const;
  void know(TableState state, std::optional<double> position);
  void lose(const std::string& why);

  const std::unique_ptr<SerialLine> line_;
  const std::vector<TableProfile> profiles_;
  const TableProfile* profile_;  // the one that it answers to; the first before that is known
  std::unique_ptr<TableDialog> dialog_;
  std::unique_ptr<TableMotion> motion_;
  std::atomic<double> origin_ = 0.0;  // [units] where it counts 0
  bool hasIndex_ = false;
  bool stopping_ = false;            // a stop was not waited for
  std::optional<double> leftAlone_;  // the end of a move that cannot be stopped [units]
  std::atomic<bool> stopAsked_ = false;
  mutable std::mutex mutex_;
  Known known_;
};

}  // namespace vantage
