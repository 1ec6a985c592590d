#include "base/errors.h"

namespace vantage {

IoError::IoError(const std::string& path, const std::string& what) : Error(path + ": " + what) {}

Cancelled::Cancelled() : Error("cancelled") {}

}  // namespace vantage
