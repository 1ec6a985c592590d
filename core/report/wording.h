#pragma once

#include <string>
#include <string_view>

#include "acquisition/command.h"
#include "acquisition/phase_times.h"
#include "base/phrase.h"
#include "planning/plan.h"
#include "registration/verdict.h"

namespace vantage {

/// What results mean, in words: in English for the command line, its JSON and the HTML report, translated in the
/// window.

/// "slides along z", "turns about (0.7, 0.7, 0.0)", "moves freely".
[[nodiscard]] Phrase phraseOf(const WeakMotion& motion);

/// The motions joined by "and"; empty for none.
[[nodiscard]] Phrase phraseOf(const WeakMotions& motions);

/// What a verdict rests on, as part of a sentence: "only 45 % of the expected overlap fits".
[[nodiscard]] Phrase phraseOf(const Finding& finding);

/// What came of an alignment: "3 poses are possible".
[[nodiscard]] Phrase phraseOf(const StandAlignment& alignment);

/// One line for a command: "Scan 3 added".
[[nodiscard]] Phrase phraseOf(const Command& command);

/// The same in English.
template <typename Result>
requires requires(const Result& result) {
  phraseOf(result);
}
[[nodiscard]] std::string describe(const Result& result) {
  return english(phraseOf(result));
}

/// What of a scan is worked on: "every 2nd row and column"; "every row and column" of 1.
[[nodiscard]] std::string thinningText(int everyNth);

/// Why an acquisition ended, as a sentence.
[[nodiscard]] std::string_view sentenceOf(Termination termination);

/// Why a boundary edge is left, as a sentence. What is below the threshold was only looked at where the plan found
/// nothing more to scan.
[[nodiscard]] std::string_view sentenceOf(EdgeReason reason, PlanOutcome outcome);

/// What a phase is called at the head of a table, with the symbols of the paper.
[[nodiscard]] std::string_view titleOf(Phase phase);

}  // namespace vantage
