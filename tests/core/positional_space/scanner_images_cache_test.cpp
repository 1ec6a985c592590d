#include "positional_space/scanner_images_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/errors.h"
#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

class ScannerImagesCache : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ = fs::path(::testing::TempDir()) /
                 (std::string("images_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(directory_);
    fs::create_directories(directory_);
    file_ = (directory_ / "some.images").string();
  }
  void TearDown() override { fs::remove_all(directory_); }

  [[nodiscard]] std::string bytes() const {
    std::ifstream in(file_, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  void setBytes(const std::string& content) const { std::ofstream(file_, std::ios::binary) << content; }

  fs::path directory_;
  std::string file_;
};

TEST_F(ScannerImagesCache, WhatIsReadIsWhatWasWritten) {
  const ScannerImages images = computeScannerImages(testing::tiltedPinhole("0, 70"));
  writeScannerImages(images, 42, file_);
  const auto back = readScannerImages(file_, 42);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->data().imageCells, images.data().imageCells);
  EXPECT_EQ(back->data().surfaceStart, images.data().surfaceStart);
  EXPECT_EQ(back->data().receiverPositions, images.data().receiverPositions);
  EXPECT_EQ(back->data().shape.surface, PositionalSpaceSurface::Sphere);
  EXPECT_EQ(back->data().shape.angularError, images.data().shape.angularError);
  for (std::uint32_t cell = 0; cell < images.cellCount(); cell += 97) {
    EXPECT_EQ(back->cell(cell), images.cell(cell));
    EXPECT_EQ(back->ray(cell).direction, images.ray(cell).direction);
  }
}

TEST_F(ScannerImagesCache, DamageIsNoticed) {
  writeScannerImages(computeScannerImages(testing::linearStripe()), 42, file_);
  const std::string good = bytes();
  for (const std::size_t at : {std::size_t{0}, std::size_t{9}, std::size_t{30}, good.size() / 2, good.size() - 1}) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    setBytes(bad);
    EXPECT_FALSE(readScannerImages(file_, 42).has_value()) << "byte " << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{20}, good.size() - 1}) {
    setBytes(good.substr(0, size));
    EXPECT_FALSE(readScannerImages(file_, 42).has_value()) << size << " bytes";
  }
  setBytes(good + "x");
  EXPECT_FALSE(readScannerImages(file_, 42).has_value());
  setBytes(good);
  EXPECT_TRUE(readScannerImages(file_, 42).has_value());
}

// Who may write beside the cache must not choose what is written through it.
TEST_F(ScannerImagesCache, NoLinkIsFollowedAndNothingIsLeftBeside) {
  const fs::path victim = directory_ / "victim";
  std::ofstream(victim) << "mine";
  fs::create_symlink(victim, directory_ / "some.images.part");
  writeScannerImages(computeScannerImages(testing::linearStripe()), 42, file_);
  EXPECT_TRUE(readScannerImages(file_, 42).has_value());
  std::ifstream in(victim);
  std::string content;
  in >> content;
  EXPECT_EQ(content, "mine");
  fs::remove(directory_ / "some.images.part");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 2);
}

TEST_F(ScannerImagesCache, ImagesOfAnotherProfileAreNotTaken) {
  writeScannerImages(computeScannerImages(testing::linearStripe()), 42, file_);
  EXPECT_FALSE(readScannerImages(file_, 43).has_value());
  EXPECT_FALSE(readScannerImages((directory_ / "absent").string(), 42).has_value());
  EXPECT_FALSE(readScannerImages(directory_.string(), 42).has_value());
}

TEST_F(ScannerImagesCache, TheHashKnowsWhatMattersAndNothingElse) {
  const ScannerProfile profile = testing::pinhole();
  ScannerProfile other = profile;
  other.name = "renamed";
  other.noise.rangeSigma = 5.0;
  EXPECT_EQ(contentHash(profile), contentHash(other));
  other.positionalSpace.columns = 45;
  EXPECT_NE(contentHash(profile), contentHash(other));
  EXPECT_NE(contentHash(profile), contentHash(testing::pinhole(44)));
  EXPECT_NE(contentHash(profile), contentHash(testing::rotatingStripe()));
}

TEST_F(ScannerImagesCache, IsFilledOnceAndRebuiltWhenDamaged) {
  const ScannerProfile profile = testing::linearStripe();
  const ScannerImages first = loadScannerImages(profile, directory_.string());
  ASSERT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 1);
  file_ = fs::directory_iterator(directory_)->path().string();
  const std::string good = bytes();
  EXPECT_EQ(loadScannerImages(profile, directory_.string()).data().imageCells, first.data().imageCells);
  setBytes("not images");
  EXPECT_EQ(loadScannerImages(profile, directory_.string()).data().imageCells, first.data().imageCells);
  EXPECT_EQ(bytes(), good);
}

TEST_F(ScannerImagesCache, ADirectoryThatCannotBeWrittenToIsNoError) {
  setBytes("a file, not a directory");
  EXPECT_GT(loadScannerImages(testing::linearStripe(), file_).cellCount(), 0U);
  EXPECT_THROW(writeScannerImages(computeScannerImages(testing::linearStripe()), 1, file_ + "/x"), IoError);
}

}  // namespace
}  // namespace vantage
