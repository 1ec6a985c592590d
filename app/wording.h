#pragma once

#include <QString>

#include "acquisition/command.h"
#include "planning/plan.h"
#include "registration/verdict.h"

namespace vantage {

/// What results mean, in the language of the window. The command line has its own words (report/wording.h).

/// "slides along z and turns about z"; empty for none.
[[nodiscard]] QString weakMotionsText(const WeakMotions& motions);

/// What a verdict rests on, as part of a sentence: "only 45 % of the expected overlap fits".
[[nodiscard]] QString findingText(const Finding& finding);

/// One line for a command: "Scan 3 added".
[[nodiscard]] QString commandText(const Command& command);

/// Why an acquisition ended, as a sentence.
[[nodiscard]] QString terminationText(Termination termination);

/// Why boundary edges are left, in a few words. What is below the threshold was only looked at where the plan found
/// nothing more to scan.
[[nodiscard]] QString edgeReasonText(EdgeReason reason, PlanOutcome outcome);

/// What several edges of a class are called.
[[nodiscard]] QString edgeClassText(EdgeClass edgeClass);

}  // namespace vantage
