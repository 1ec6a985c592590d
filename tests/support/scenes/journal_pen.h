#pragma once

#include <utility>

#include "acquisition/journal.h"

namespace vantage::testing {

/// Writes steps into a journal that no command made: for loads and damages that would take too long to acquire.
class JournalPen {
 public:
  static void record(Journal& journal, const Command& command, AcquisitionState state) {
    journal.record(command, std::move(state));
  }
};

}  // namespace vantage::testing
