#include "base/log.h"

namespace vantage {
namespace {

class NoLog final : public LogSink {
 public:
  void write(LogLevel /*level*/, std::string_view /*message*/) override {}
};

}  // namespace

LogSink& LogSink::none() {
  static NoLog sink;
  return sink;
}

}  // namespace vantage
