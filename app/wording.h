#pragma once

#include <QString>

#include "acquisition/command.h"
#include "base/phrase.h"
#include "planning/plan.h"

namespace vantage {

/// What results mean, in the language of the window.

/// What core has words for (see report/wording.h), with the window's figures.
[[nodiscard]] QString translated(const Phrase& phrase);

/// One line for a command: "Scan 3 added"; an end as terminationText has it.
[[nodiscard]] QString commandText(const Command& command);

/// Why an acquisition ended, as a sentence.
[[nodiscard]] QString terminationText(Termination termination);

/// Why boundary edges are left, in a few words. What is below the threshold was only looked at where the plan found
/// nothing more to scan.
[[nodiscard]] QString edgeReasonText(EdgeReason reason, PlanOutcome outcome);

/// What several edges of a class are called.
[[nodiscard]] QString edgeClassText(EdgeClass edgeClass);

}  // namespace vantage
