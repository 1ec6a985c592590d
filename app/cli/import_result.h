#pragma once

#include <string>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "cli/command.h"

namespace vantage {

/// What an import is called in its result.
struct ImportNames {
  std::string session;
  std::vector<std::string> labels;  ///< of the scans, in order
  std::string readLines;            ///< as what they were read
};

/// Says what an import came to: every scan with its verdict, the model, and what is still void.
void announceImport(const ImportNames& names, const AcquisitionState& state, CommandContext& context,
                    const Progress& progress);

}  // namespace vantage
