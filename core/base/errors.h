#pragma once

#include <stdexcept>
#include <string>

namespace vantage {

/// Base of everything the engine throws on purpose. The message is one sentence for the operator: what, which object,
/// which number, which limit.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A precondition is broken: the caller or a file handed over values that cannot be worked with.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// The world failed while reading or writing a file.
class IoError : public Error {
 public:
  /// @param path the file; it leads the message.
  IoError(const std::string& path, const std::string& what);
};

/// A scanner or turntable failed.
class DeviceError : public Error {
 public:
  using Error::Error;
};

/// The operation was asked to stop. Nothing it worked on has changed.
class Cancelled : public Error {
 public:
  Cancelled();
};

}  // namespace vantage
