#pragma once

#include <string>

#include "session/session.h"

namespace vantage::testing {

/// Writes a session of so many views of 260 x 260 samples each, one step per view, with a model. The views show a wavy
/// wall each and were never registered: it is for what depends on size only.
void writeLargeSession(const std::string& path, int views);

}  // namespace vantage::testing
