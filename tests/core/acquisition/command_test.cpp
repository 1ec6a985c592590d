#include "acquisition/command.h"

#include <gtest/gtest.h>

#include <set>

namespace vantage {
namespace {

// Session files of all times name commands so.
TEST(Command, KindsAreCalledWhatFilesCallThem) {
  EXPECT_EQ(kindOf(ChangeSettings{}), "change_settings");
  EXPECT_EQ(kindOf(AddScan{}), "add_scan");
  EXPECT_EQ(kindOf(ImportScans{}), "import_scans");
  EXPECT_EQ(kindOf(ChoosePosition{}), "choose_position");
  EXPECT_EQ(kindOf(LeaveOutView{}), "leave_out");
  EXPECT_EQ(kindOf(TakeBackView{}), "take_back");
  EXPECT_EQ(kindOf(TakeAsFrom{}), "take_as_from");
  EXPECT_EQ(kindOf(Finish{}), "finish");
  EXPECT_EQ(kindOf(TakeOver{}), "take_over");
  EXPECT_EQ(kindOf(TurnObject{}), "turn_object");
  EXPECT_EQ(kindOf(PlaceStand{}), "place_stand");
  EXPECT_EQ(kindOf(AlignStand{}), "align");
  EXPECT_EQ(kindOf(ChooseStandPose{}), "choose_stand_pose");
  EXPECT_EQ(kindOf(TakeReference{}), "take_reference");
  EXPECT_EQ(kindOf(ChangeMode{}), "change_mode");
}

template <std::size_t... I>
std::set<std::string_view> allKinds(std::index_sequence<I...> /*kinds*/) {
  return {kindOf(Command(std::in_place_index<I>))...};
}

TEST(Command, NoTwoKindsAreCalledTheSame) {
  constexpr std::size_t kKinds = std::variant_size_v<Command>;
  const std::set<std::string_view> kinds = allKinds(std::make_index_sequence<kKinds>());
  EXPECT_EQ(kinds.size(), kKinds);
  EXPECT_FALSE(kinds.contains(""));
}

TEST(Command, WhatIsNotSaidIsNotMadeUp) {
  EXPECT_FALSE(ChoosePosition{}.position);
  EXPECT_FALSE(TurnObject{}.T_object_table);
  EXPECT_FALSE(AddScan{}.predicted);
  EXPECT_EQ(Finish{}.termination, Termination::EndedByOperator);
}

}  // namespace
}  // namespace vantage
