#include "devices/openni2_sensor.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "devices/openni2_camera.h"

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

// Between two looks at the stop.
constexpr std::chrono::milliseconds kTick{100};
// Two frames of a camera that measures are never the same; so many in a row are no chance.
constexpr int kMostRepeats = 3;

// Why frames did not come as they should.
enum class Trouble { None, Gone, Away, Silent, Repeating, Black };

std::string sentenceOf(Trouble trouble, const OpenNi2Options& options) {
  const auto seconds = [](std::chrono::milliseconds time) {
    return std::to_string(static_cast<int>(std::lround(static_cast<double>(time.count()) / 1000.0))) + " s";
  };
  switch (trouble) {
    case Trouble::Gone:
      return "it was disconnected, came back and was disconnected again: look at its cable, and repeat the scan";
    case Trouble::Away:
      return "it was disconnected and did not come back within " + seconds(options.comeback) +
             ": plug it in again and repeat the scan";
    case Trouble::Silent:
      return "it has sent no picture for " + seconds(options.silence) +
             ", not even after it was opened anew: unplug it, plug it in again and repeat the scan";
    case Trouble::Repeating:
      return "it sends the same picture again and again: unplug it, plug it in again and repeat the scan";
    default:
      return "it sees nothing: is it covered, is its light on, and is the object neither too near nor too far?";
  }
}

// The cameras that a device may mean.
std::vector<ListedCamera> meant(const OpenNi2Device& device) {
  std::vector<ListedCamera> cameras = listedCameras();
  if (!device.uri.empty()) std::erase_if(cameras, [&](const ListedCamera& c) { return c.uri != device.uri; });
  return cameras;
}

// The first that can be used. @throws DeviceError, of the last where none can
std::unique_ptr<OpenNi2Camera> openFirst(const OpenNi2Device& device, const OpenNi2Camera::SizeTest& sizeWillDo,
                                         std::string& uri) {
  std::optional<DeviceError> failure;
  for (const ListedCamera& camera : meant(device)) {
    try {
      auto open = std::make_unique<OpenNi2Camera>(camera, sizeWillDo);
      uri = camera.uri;
      return open;
    } catch (const DeviceError& e) {
      failure = e;
    }
  }
  if (failure) throw *failure;
  throw DeviceError(device.uri.empty() ? "no depth camera is connected: plug one in, and look whether you may use it"
                                       : "no depth camera " + device.uri +
                                             " is connected: plug it in, or choose one that vantage-cli devices lists");
}

class OpenNi2Sensor final : public RangeSensor {
 public:
  OpenNi2Sensor(OpenNi2Device device, std::shared_ptr<const ScannerProfile> profile, const OpenNi2Options& options)
      : device_(std::move(device)), profile_(std::move(profile)), options_(options) {}

  [[nodiscard]] std::string identity() const override {
    return "depth camera" + (name_.empty() ? (device_.uri.empty() ? "" : " " + device_.uri) : " " + name_);
  }

  void open(const Progress& progress) override {
    if (camera_ && !camera_->isGone()) return;
    progress.checkpoint(0.0);
    camera_.reset();
    std::string uri;
    auto camera = openFirst(
        device_, [&](int columns, int rows) { return sizeFits(columns, rows, *profile_->rays); }, uri);
    try {
      if (camera->model() != model_) pixels_ = pixelsOfRays(camera->model(), *profile_);
      model_ = camera->model();
    } catch (const InvalidInput& e) {
      throw DeviceError("depth camera " + camera->name() + ": " + e.what());
    }
    // From now on it is this one.
    device_.uri = uri;
    name_ = camera->name();
    camera_ = std::move(camera);
    lost_ = false;
  }

  void close() noexcept override {
    camera_.reset();
    lost_ = false;
  }

  [[nodiscard]] std::optional<std::string> notReady() const override {
    if (!camera_ && !lost_) return "it is not open";
    if ((!camera_ || camera_->isGone()) && meant(device_).empty()) return "it was disconnected: plug it in again";
    return {};
  }

  [[nodiscard]] RangeImage capture(const Progress& progress) override {
    if (!camera_ && !lost_) throw DeviceError(identity() + ": it is not open");
    Trouble trouble = Trouble::None;
    for (int attempt = 0; attempt < 2; ++attempt) {
      if (trouble != Trouble::None || !camera_ || camera_->isGone()) openAnew(progress);
      std::vector<DepthFrame> frames;
      trouble = take(frames, progress);
      if (trouble == Trouble::None) return imageOf(averageDepth(frames, options_.average));
      if (trouble == Trouble::Black) break;
    }
    throw DeviceError(identity() + ": " + sentenceOf(trouble, options_));
  }

 private:
  // Old streams of a camera that is back stay silent. One that was unplugged takes a while until it can be opened.
  void openAnew(const Progress& progress) {
    const bool gone = lost_ || camera_->isGone();
    const auto deadline = Clock::now() + options_.comeback;
    lost_ = true;
    camera_.reset();
    while (true) {
      try {
        return open(progress);
      } catch (const DeviceError&) {
        if (!gone) throw;
        if (Clock::now() > deadline) throw DeviceError(identity() + ": " + sentenceOf(Trouble::Away, options_));
      }
      waitATick(progress);
    }
  }

  static void waitATick(const Progress& progress) {
    progress.checkpoint(0.0);
    std::this_thread::sleep_for(kTick);
  }

  // Lets go by what may have been seen before the table stopped, and takes as many frames as make an image.
  Trouble take(std::vector<DepthFrame>& frames, const Progress& progress) {
    const auto settled = Clock::now() + options_.settle;
    auto last = Clock::now();
    DepthFrame previous;
    int repeats = 0;
    int black = 0;
    while (frames.size() < static_cast<std::size_t>(options_.frames)) {
      progress.checkpoint(static_cast<double>(frames.size()) / options_.frames);
      auto frame = camera_->next(kTick);
      if (camera_->isGone()) return Trouble::Gone;
      if (!frame) {
        if (Clock::now() - last > options_.silence) return Trouble::Silent;
        continue;
      }
      last = Clock::now();
      if (last < settled) continue;
      if (std::all_of(frame->begin(), frame->end(), [](std::uint16_t depth) { return depth == 0; })) {
        if (++black >= options_.frames) return Trouble::Black;
        continue;
      }
      const bool same = *frame == previous;
      repeats = same ? repeats + 1 : 0;
      if (repeats >= kMostRepeats) return Trouble::Repeating;
      if (same) continue;
      previous = *frame;
      frames.push_back(std::move(*frame));
    }
    return Trouble::None;
  }

  [[nodiscard]] RangeImage imageOf(const std::vector<float>& depth) const {
    RangeImage image;
    image.rays = profile_->rays;
    image.range.assign(image.rays->size(), kNoSample);
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      const double range = pixels_.stretch[i] * camera_->unit() * static_cast<double>(depth[pixels_.pixel[i]]);
      if (range > 0.0 && range >= profile_->minRange && range <= profile_->maxRange)
        image.range[i] = static_cast<float>(range);
    }
    return image;
  }

  OpenNi2Device device_;
  std::shared_ptr<const ScannerProfile> profile_;
  OpenNi2Options options_;
  std::string name_;
  std::unique_ptr<OpenNi2Camera> camera_;
  bool lost_ = false;  // it was open, and is to be opened again
  CameraModel model_;
  PixelsOfRays pixels_;  // of the model
};

}  // namespace

std::vector<CameraInfo> connectedCameras(const Progress& progress) {
  std::vector<CameraInfo> cameras;
  for (const ListedCamera& listed : listedCameras()) {
    progress.checkpoint(0.0);
    CameraInfo info{listed.uri, listed.vendor, listed.name, {}, {}};
    try {
      info.model = OpenNi2Camera(listed).model();
    } catch (const DeviceError& e) {
      info.problem = e.what();
    }
    cameras.push_back(std::move(info));
  }
  return cameras;
}

ProfileSource profileOfCamera(const OpenNi2Device& device, const CameraPlace& place, std::optional<int> columns,
                              const Progress& progress) {
  progress.checkpoint(0.0);
  OpenNi2Camera::SizeTest size;
  if (columns) size = [&](int imageColumns, int /*rows*/) { return imageColumns == *columns; };
  std::string uri;
  const auto camera = openFirst(device, size, uri);
  return profileOf(camera->model(), camera->name(), place);
}

std::shared_ptr<RangeSensor> makeOpenNi2Sensor(const OpenNi2Device& device,
                                               std::shared_ptr<const ScannerProfile> profile,
                                               const OpenNi2Options& options) {
  if (options.frames < 1) throw InvalidInput("a range image of a depth camera is made of at least 1 frame");
  return std::make_shared<OpenNi2Sensor>(device, std::move(profile), options);
}

}  // namespace vantage
