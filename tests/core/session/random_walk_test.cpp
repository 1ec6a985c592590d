#include <gtest/gtest.h>

#include <filesystem>

#include "acquisition/apply_command.h"
#include "acquisition/next_scan.h"
#include "base/random.h"
#include "session/session.h"
#include "session/state_hash.h"
#include "support/scenes/small_scene.h"
#include "support/test_data.h"

// Walks through a session at random: commands, undo, redo and reopening, beside a plain list of what every step led to.

namespace vantage {
namespace {

class Walk {
 public:
  explicit Walk(const std::string& path)
      : path_(path),
        session_(testing::createSmallSession(path, {})),
        images_(std::make_shared<const ScannerImages>(computeScannerImages(*session_.profile()))) {
    expected_.push_back(stateHash(*session_.state()));
  }

  void step() {
    const std::uint64_t dice = random_.below(1000);
    if (dice < 330) {
      if (session_.history().canUndo()) move(-1);
    } else if (dice < 640) {
      if (session_.history().canRedo()) move(1);
    } else if (dice < 645) {
      reopen();
    } else {
      command(dice);
    }
    EXPECT_EQ(stateHash(*session_.state()), expected_[at_]);
    EXPECT_EQ(session_.history().current().hash, expected_[at_]);
  }

  [[nodiscard]] int scansAdded() const { return added_; }
  [[nodiscard]] int viewsLeftOut() const { return leftOut_; }

 private:
  void move(int by) {
    Acquisition acquisition(session_);
    by < 0 ? acquisition.undo() : acquisition.redo();
    at_ += static_cast<std::size_t>(by);
  }

  void reopen() {
    session_ = Session::open(moved(), SessionAccess::Write);
    ASSERT_EQ(session_.history().size(), expected_.size());
    ASSERT_EQ(session_.history().cursor(), at_);
    const std::size_t other = random_.below(expected_.size());
    EXPECT_EQ(stateHash(*session_.state(other)), expected_[other]);
  }

  // One program at a time may write: the old one closes before the new one opens.
  std::string moved() {
    const std::string other = path_ + ".other" + std::to_string(others_++);
    session_ = testing::createSmallSession(other, {});
    return path_;
  }

  void command(std::uint64_t dice) {
    const auto state = session_.state();
    if (dice < 655 && countScans(*state, ScanStatus::In) < 4) return add(*state);
    if (dice < 665 && countScans(*state, ScanStatus::In) > 1) return leaveOut(*state);
    if (dice < 675 && countScans(*state, ScanStatus::LeftOut) > 0)
      return apply(TakeBackView{scansOf(*state, ScanStatus::LeftOut)[0]->number});
    if (dice < 800) return apply(ChoosePosition{static_cast<int>(random_.below(24))});
    if (dice < 860) return apply(ChangeMode{state->mode == Mode::Assisted ? Mode::Automatic : Mode::Assisted});
    const Finish end{random_.below(2) == 0 ? Termination::EndedByOperator : Termination::Running};
    if (!mayDo(*state, end)) apply(end);
  }

  void add(const AcquisitionState& state) {
    const KeptScan* last = lastView(state);
    const int position = last == nullptr ? 0 : (last->station().position.value() + 2) % 24;
    const Rig rig =
        testing::simulation(testing::smallObject(), session_.profile(), {}, static_cast<int>(session_.scanCount()));
    apply(AddScan{session_.keepScan(scanFrom(rig, position, Progress())).number, {}});
    ++added_;
  }

  void leaveOut(const AcquisitionState& state) {
    const auto views = scansOf(state, ScanStatus::In);
    apply(LeaveOutView{views[random_.below(views.size())]->number});
    ++leftOut_;
  }

  void apply(const Command& command) {
    Acquisition(session_, {{}, images_}).carryOut(command);
    expected_.resize(++at_);
    expected_.push_back(stateHash(*session_.state()));
  }

  std::string path_;
  Session session_;
  int others_ = 0;
  std::shared_ptr<const ScannerImages> images_;
  Random random_{7};
  std::vector<std::uint64_t> expected_;
  std::size_t at_ = 0;
  int added_ = 0;
  int leftOut_ = 0;
};

TEST(RandomWalk, TenThousandCommandsUndosAndRedosReturnToEqualStates) {
  const testing::TemporaryFolder folder;
  // In memory where there is such a folder: what is tested is not the disk.
  const std::string file = "vantage_walk_" + std::to_string(getpid()) + ".vantage";
  const bool memory = std::filesystem::is_directory("/dev/shm");
  const std::string path = memory ? "/dev/shm/" + file : folder.file(file);
  {
    Walk walk(path);
    for (int i = 0; i < 10000 && !::testing::Test::HasFailure(); ++i) walk.step();
    EXPECT_GT(walk.scansAdded(), 20);
    EXPECT_GT(walk.viewsLeftOut(), 20);
  }
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
    if (entry.path().string().starts_with(path)) std::filesystem::remove(entry.path());
}

}  // namespace
}  // namespace vantage
