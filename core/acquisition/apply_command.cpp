#include "acquisition/apply_command.h"

#include "acquisition/may_do.h"
#include "acquisition/refusal_error.h"

namespace vantage {

AcquisitionState applyCommand(const AcquisitionState& state, const Command& command, const CommandInput& input,
                              const Progress& progress) {
  if (const auto refusal = mayDo(state, command)) throwRefusal(*refusal);
  const CommandTools tools(input, progress);
  return std::visit([&](const auto& c) { return c.carriedOut(state, tools); }, command);
}

}  // namespace vantage
