#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/errors.h"

namespace vantage::testing {

/// Expects `action` to throw an `E` whose message contains every one of the parts.
template <typename E, typename Action>
void expectError(const Action& action, const std::vector<std::string>& parts) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const E& e) {
    const std::string message = e.what();
    for (const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
  } catch (const std::exception& e) {
    ADD_FAILURE() << "another exception: " << e.what();
  }
}

}  // namespace vantage::testing
