#include "report/reading_words.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(ReadingWords, SayUnitAndSideAndWhy) {
  ScanReading reading;
  reading.unit = 1000.0;
  reading.poseUnit = 1000.0;
  reading.unitKnownBy = KnownBy::Evidence;
  EXPECT_EQ(english(phraseOf(reading)),
            "1 unit = 1000.000 mm (told by the numbers), the scanner looks along -z (assumed)");
  reading.sight = Vec3::UnitX();
  reading.sightKnownBy = KnownBy::Operator;
  EXPECT_NE(english(phraseOf(reading)).find("looks along +x (as given)"), std::string::npos);
  reading.sightKind = SightKind::Turntable;
  EXPECT_NE(english(phraseOf(reading)).find("like a cylinder"), std::string::npos);
}

TEST(ReadingWords, SayEverythingThatIsNotAsUsual) {
  ScanReading reading;
  reading.noSample = NoSampleMark::Zero;
  reading.dropped = 12;
  reading.exchanged = true;
  reading.placed = true;
  reading.offset = Vec3(403000000, -2000, 0);
  reading.poseUnit = 1000.0;
  reading.turnsAbout = Axis::Y;
  const std::string text = english(phraseOf(reading));
  for (const char* part :
       {"12 cells with the point (0, 0, 0)", "rows and columns are exchanged", "no pose is applied",
        "(403000000, -2000, 0) mm was taken off", "another unit: 1 = 1000.000 mm", "the poses turn about y"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

}  // namespace
}  // namespace vantage
