#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "report/completeness.h"
#include "why_card.h"

namespace vantage {

/// How complete a model is, in words: what is covered, whether it is closed, and what to do about the rest.
struct CompletenessCard {
  QString headline;
  bool good = false;              ///< nothing that can be reached is missing
  std::optional<double> reached;  ///< share of what the scanner can reach, 0..1; nothing where that is not known
  std::vector<WhyFigure> figures;
  QString advice;
};

/// @param state with the object as its model, see withObject @param completeness of that model
[[nodiscard]] CompletenessCard makeCompletenessCard(const AcquisitionState& state, const Completeness& completeness);

}  // namespace vantage
