#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "integration/consensus.h"
#include "integration/zipper_options.h"
#include "io/placement.h"
#include "planning/planner.h"
#include "registration/alignment.h"
#include "registration/icp.h"
#include "registration/multi_view.h"
#include "scanner/scan_cut.h"
#include "scanner/thinning.h"
#include "scanner/triangulation.h"

namespace vantage {

/// How the next position is chosen: by positional space, or by a baseline to compare with. Everything else is shared.
struct Strategy {
  enum class Kind : std::uint8_t { PositionalSpace, Uniform, Random };
  Kind kind = Kind::PositionalSpace;
  int uniformViews = 0;  ///< N of uniform:N
};

/// "ps", "uniform:N" or "random". @throws InvalidInput for anything else.
[[nodiscard]] Strategy parseStrategy(std::string_view text);
[[nodiscard]] std::string name(const Strategy& strategy);

/// What the simulated scanner looks at, and how.
struct SimulationSettings {
  std::string object;  ///< file that it looks at; empty for recorded scans
  Placement placement = Placement::AsIs;
  std::optional<double> unit;  ///< of the file [mm]; unset: millimetres, where that can be
  std::uint64_t seed = 1;      ///< of noise and mechanics, and of the random strategy
  bool ideal = false;          ///< no noise, no dropout, no mechanical error
};

/// What a session was asked to do: the options of every operation that its steps run. What follows from the scanner's
/// profile (breakdown angles, prior and ties of the mechanics) is no setting, see stepOptionsFor.
struct AcquisitionSettings {
  SimulationSettings simulation;
  Strategy strategy;
  int firstView = 0;
  int maxViews = 40;
  CutOptions cut;  ///< off: real scanners see more than the object, see cutForRealScanners
  ThinningOptions thinning;
  TriangulationOptions triangulation;
  IcpOptions registration;
  MultiViewOptions refinement;
  AlignmentSampling alignment;         ///< of scans that are imported together
  ZipperOptions zipper{.mend = true};  ///< mended once all scans are there: imports
  ConsensusOptions consensus;
  PlannerOptions planner;
};

/// What a session file means by settings that it does not name (see SettingField::before).
[[nodiscard]] AcquisitionSettings settingsBefore();

/// Whether no setting contradicts another: no fine gate is larger than the coarse one.
[[nodiscard]] bool agree(const AcquisitionSettings& settings);
/// @throws InvalidInput that names the settings that contradict each other
void checkSettings(const AcquisitionSettings& settings);

/// Whether an acquisition that has scans can go on with other settings: its object stays, and so does how scans are
/// cut, thinned and triangulated, which is done anew whenever a session is opened.
[[nodiscard]] bool mayFollow(const AcquisitionSettings& before, const AcquisitionSettings& after);
/// @throws InvalidInput that names the setting that cannot change
void checkChange(const AcquisitionSettings& before, const AcquisitionSettings& after);

/// Whether the settings are equal in every field of the table.
[[nodiscard]] bool operator==(const AcquisitionSettings& a, const AcquisitionSettings& b);

/// Equal for settings that are equal. Settings as they were before they were introduced count for nothing, so that a
/// new one leaves the hashes of old sessions as they are.
[[nodiscard]] std::uint64_t settingsHash(const AcquisitionSettings& settings);

}  // namespace vantage
