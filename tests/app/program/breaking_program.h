#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace vantage::testing {

/// Runs something in a process of its own that leaves traces of crashes. @return the signal that ended it; 0 for none
int endOfProgram(const std::string& name, const std::filesystem::path& folder, const std::string& session,
                 const std::function<void()>& last);

}  // namespace vantage::testing
