#pragma once

#include <string>

#include "base/phrase.h"
#include "session/loss.h"

namespace vantage {

/// What of a session is lost, in words. `path` is the session's.
[[nodiscard]] Phrase phraseOf(const Loss& loss, const std::string& path);

}  // namespace vantage
