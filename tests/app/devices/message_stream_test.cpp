#include "devices/serial/message_stream.h"

#include <gtest/gtest.h>

#include <vector>

namespace vantage {
namespace {

using Time = MessageStream::Time;
using std::chrono::milliseconds;

std::vector<std::string> all(MessageStream& stream, Time now) {
  std::vector<std::string> messages;
  while (const auto message = stream.next(now)) messages.push_back(*message);
  return messages;
}

TEST(MessageStream, AreTheSameHoweverTheBytesComeAndWhateverEndsALine) {
  const std::vector<std::string> expected{"ok", "<Idle|MPos:1.000>", "ok"};
  for (const std::string end : {"\r", "\n", "\r\n", "\n\r", "\r\r\n"}) {
    const std::string bytes = "ok" + end + "<Idle|MPos:1.000>" + end + end + "ok" + end;
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
      MessageStream stream("\r\n", "", "");
      for (std::size_t i = 0; i < bytes.size(); i += piece) stream.feed(bytes.substr(i, piece), Time{});
      EXPECT_EQ(all(stream, Time{}), expected) << "pieces of " << piece;
    }
  }
}

TEST(MessageStream, APromptStandsAloneAndIsFollowedByRest) {
  const auto later = [](int time) { return Time{} + milliseconds(time); };
  MessageStream stream("\r\n", ">", "");
  stream.feed("G04 T80;\n>", later(0));
  EXPECT_EQ(stream.next(later(1)), "G04 T80;");
  EXPECT_EQ(stream.next(later(1)), std::nullopt) << "something may follow";
  EXPECT_EQ(stream.next(later(100)), ">");

  stream.feed("x>y\x01>", later(200));
  EXPECT_EQ(stream.next(later(300)), std::nullopt) << "part of garbage";
  stream.feed(">", later(1000));
  EXPECT_EQ(stream.next(later(1000)), "x>y\x01>") << "garbage does not keep a later prompt from being one";
  EXPECT_EQ(stream.next(later(1100)), ">");
}

TEST(MessageStream, APromptThatCameSomeTimeAfterRubbishIsOneWhenTheLineRestsLonger) {
  const auto later = [](int time) { return Time{} + milliseconds(time); };
  MessageStream stream("\r\n", ">", "");
  stream.feed("x>y\x01", later(0));
  stream.feed(">", later(100));
  EXPECT_EQ(stream.next(later(200)), std::nullopt);
  EXPECT_EQ(stream.next(later(400)), "x>y\x01");
  EXPECT_EQ(stream.next(later(400)), ">");
  stream.feed("x>y\x01", later(1000));
  stream.feed(">", later(1010));
  EXPECT_EQ(stream.next(later(1400)), std::nullopt) << "part of the rubbish";
}

TEST(MessageStream, DropsHeartbeatsAndWhatIsLongerThanAnyMessage) {
  MessageStream stream(";", "", "#");
  stream.feed("#CR+#OK;##" + std::string(100000, 'x') + ";CR+OK;", Time{});
  EXPECT_EQ(all(stream, Time{}), (std::vector<std::string>{"CR+OK", "CR+OK"}));
}

}  // namespace
}  // namespace vantage
