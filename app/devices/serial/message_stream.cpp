#include "devices/serial/message_stream.h"

#include <utility>

namespace vantage {
namespace {

// No firmware says more in one message: what is longer is rubbish, such as another speed makes of it.
constexpr std::size_t kLongest = 300;
// A prompt is one when nothing follows it at once.
constexpr std::chrono::milliseconds kRest{40};
// What stands before a prompt without an end does not belong to it after so long.
constexpr std::chrono::milliseconds kForgotten{250};

}  // namespace

MessageStream::MessageStream(std::string ends, std::string prompt, std::string heartbeat)
    : ends_(std::move(ends)), prompt_(std::move(prompt)), heartbeat_(std::move(heartbeat)) {}

void MessageStream::take(char c) {
  if (heartbeat_.find(c) != std::string::npos) return;
  if (ends_.find(c) == std::string::npos) {
    if (isPrompt() && c != prompt_[0]) begun_.clear();
    begun_ += c;
    if (begun_.size() > kLongest) {
      begun_.clear();
      overlong_ = true;
    }
    return;
  }
  if (!begun_.empty() && !overlong_) messages_.push_back(begun_);
  begun_.clear();
  overlong_ = false;
}

void MessageStream::feed(std::string_view bytes, Time now) {
  if (!prompt_.empty() && !begun_.empty() && now - last_ > kForgotten) {
    messages_.push_back(begun_);
    begun_.clear();
  }
  behindRubbish_ = !prompt_.empty() && bytes == prompt_ && !begun_.empty() && !isPrompt() && now - last_ >= kRest;
  last_ = now;
  for (const char c : bytes) take(c);
}

bool MessageStream::isPrompt() const {
  return !prompt_.empty() && !begun_.empty() && begun_.find_first_not_of(prompt_) == std::string::npos;
}

std::optional<std::string> MessageStream::next(Time now) {
  if (messages_.empty() && isPrompt() && now - last_ >= kRest) {
    messages_.push_back(prompt_);
    begun_.clear();
  }
  // One that came by itself, some time behind rubbish, takes longer to be known.
  if (messages_.empty() && behindRubbish_ && now - last_ > kForgotten) {
    behindRubbish_ = false;
    begun_.pop_back();
    messages_.push_back(std::exchange(begun_, {}));
    messages_.push_back(prompt_);
  }
  if (messages_.empty()) return std::nullopt;
  std::string message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

void MessageStream::clear() {
  messages_.clear();
  begun_.clear();
  overlong_ = behindRubbish_ = false;
}

}  // namespace vantage
