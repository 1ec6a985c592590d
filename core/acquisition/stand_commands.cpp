#include "acquisition/stand_commands.h"

#include <algorithm>
#include <utility>

#include "acquisition/command_tools.h"
#include "acquisition/stand_composites.h"
#include "acquisition/stand_merging.h"
#include "acquisition/step_options.h"
#include "acquisition/steps.h"

namespace vantage {
namespace {

using Answer = std::optional<Refusal>;

// Whether a stand is there and not known yet.
Answer mayPlace(const AcquisitionState& state, int stand) {
  if (stand < 0 || stand > state.stand()) return Refusal{RefusalReason::NoSuchStand, stand};
  if (isOfObject(state, stand)) return Refusal{RefusalReason::StandKnown, stand};
  return {};
}

// Whether a stand has views that are not of the object yet.
Answer mayAlign(const AcquisitionState& state, int stand) {
  if (const Answer refusal = mayPlace(state, stand)) return refusal;
  const std::vector<int> stands = standsToAlign(state);
  if (std::find(stands.begin(), stands.end(), stand) == stands.end())
    return Refusal{RefusalReason::NothingToAlign, stand};
  return {};
}

// With what an alignment came to, in a stand.
AcquisitionState withAlignment(const AcquisitionState& state, int stand, StandAlignment alignment) {
  AcquisitionState next = state;
  next.stands[static_cast<std::size_t>(stand)].alignment = std::make_shared<const StandAlignment>(std::move(alignment));
  return next;
}

const StandAligner& alignerOf(const CommandTools& tools) {
  return tools.input().aligner != nullptr ? *tools.input().aligner : usualStandAligner();
}

AlignedStand aligned(const AcquisitionState& state, const AlignStand& command, const CommandTools& tools,
                     const Progress& progress) {
  const StepOptions options = stepOptionsFor(state);
  const Composite object = compositeForAligner(withObject(state), options);
  const Composite stand = compositeForAligner(withComposite(state, command.stand), options);
  return alignerOf(tools).align(object, stand, command.picks, progress);
}

}  // namespace

Answer TurnObject::mayDo(const AcquisitionState& state) const {
  if (!state.profile) return Refusal{RefusalReason::NoProfile, {}};
  if (!state.model && state.aside.empty()) return Refusal{RefusalReason::NothingScanned, {}};
  return {};
}

AcquisitionState TurnObject::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = state;
  next.stands.push_back({T_object_table, down, nullptr, referenceOf(state.stands)});
  next.chosenPosition.reset();
  next.termination = Termination::Running;
  return tools.replanned(withComposite(next, compositeOf(next, next.stand())));
}

Answer PlaceStand::mayDo(const AcquisitionState& state) const {
  return mayPlace(state, stand);
}

AcquisitionState PlaceStand::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  return tools.replanned(mergedStand(state, stand, T_object_table, {}, stepOptionsFor(state), tools.firstHalf()));
}

Answer AlignStand::mayDo(const AcquisitionState& state) const {
  return mayAlign(state, stand);
}

AcquisitionState AlignStand::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  const Progress first = tools.firstHalf();
  AlignedStand found = aligned(state, *this, tools, first.part(0.0, 0.7, name(Phase::Register)));
  const std::vector<StandPose>& candidates = found.alignment.candidates;
  const auto best = std::find_if(candidates.begin(), candidates.end(), [](const StandPose& p) { return p.possible; });
  const bool isGood = found.alignment.verdict == AlignmentVerdict::Good && best != candidates.end();
  if (isGood) found.alignment.used = static_cast<int>(best - candidates.begin());
  const AcquisitionState next = withAlignment(state, stand, std::move(found.alignment));
  if (!isGood) return next;
  const StandAlignment& alignment = *next.stands[static_cast<std::size_t>(stand)].alignment;
  const StandPose& pose = alignment.candidates[static_cast<std::size_t>(*alignment.used)];
  return tools.replanned(
      mergedStand(next, stand, pose.T_object_stand, found.poses, stepOptionsFor(state), first.part(0.7, 1.0)));
}

Answer ChooseStandPose::mayDo(const AcquisitionState& state) const {
  if (const Answer refusal = mayPlace(state, stand)) return refusal;
  const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment;
  if (!alignment) return Refusal{RefusalReason::NotAligned, stand};
  if (pose < 0 || pose >= static_cast<int>(alignment->candidates.size()))
    return Refusal{RefusalReason::NoSuchPose, pose};
  if (!despite && !alignment->candidates[static_cast<std::size_t>(pose)].possible)
    return Refusal{RefusalReason::PoseContradicted, pose};
  return {};
}

AcquisitionState ChooseStandPose::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  StandAlignment alignment = *state.stands[static_cast<std::size_t>(stand)].alignment;
  const StandPose chosen = alignment.candidates[static_cast<std::size_t>(pose)];
  alignment.used = pose;
  alignment.choice = chosen.possible ? PoseChoice::Operator : PoseChoice::Despite;
  return tools.replanned(mergedStand(withAlignment(state, stand, std::move(alignment)), stand, chosen.T_object_stand,
                                     {}, stepOptionsFor(state), tools.firstHalf()));
}

Answer TakeReference::mayDo(const AcquisitionState& state) const {
  if (const Answer refusal = mayAlign(state, stand)) return refusal;
  if (std::count_if(state.stands.begin(), state.stands.end(), [](const Stand& s) { return !!s.T_object_table; }) > 1)
    return Refusal{RefusalReason::StandsTogether, {}};
  return {};
}

AcquisitionState TakeReference::carriedOut(const AcquisitionState& state, const CommandTools& tools) const {
  AcquisitionState next = withComposite(state, stand);
  Stand& before = next.stands[static_cast<std::size_t>(referenceOf(state.stands))];
  before.T_object_table.reset();
  before.alignment = nullptr;
  Stand& reference = next.stands[static_cast<std::size_t>(stand)];
  reference.T_object_table = Pose::Identity();
  reference.alignment = nullptr;
  return tools.replanned(withComposite(next, compositeOf(next, next.stand())));
}

}  // namespace vantage
