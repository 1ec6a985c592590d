#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "session/database.h"
#include "session/session.h"
#include "support/test_data.h"

namespace vantage::testing {

/// The sessions in tests/core/session/data, which earlier versions of the program wrote: "schema_1", ...
[[nodiscard]] const std::vector<std::string>& earlierSessions();
/// The path of one of them.
[[nodiscard]] std::string earlierSession(const std::string& name);

/// The simulated scanner that these sessions were made with, as it goes on with one of them.
[[nodiscard]] AcquisitionTools earlierTools(const Session& session);

/// All bytes of a file.
[[nodiscard]] std::string bytesOf(const std::string& path);

/// The first column of every row, and of the first row.
[[nodiscard]] std::vector<std::string> textsOf(Database& database, const std::string& query);
[[nodiscard]] std::vector<std::byte> blobOf(const std::string& path, const std::string& query);

/// The model that the last step of a session file led to.
[[nodiscard]] std::vector<std::byte> lastModelOf(const std::string& path);

/// Tests on copies of these sessions in a folder of their own.
class EarlierVersions : public ::testing::Test {
 protected:
  [[nodiscard]] std::string copyOf(const std::string& name) const {
    return folder_.write(name + ".vantage", bytesOf(earlierSession(name)));
  }

  TemporaryFolder folder_;
};

}  // namespace vantage::testing
