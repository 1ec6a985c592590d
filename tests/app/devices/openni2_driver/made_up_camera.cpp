// An OpenNI2 driver for tests: two cameras, one of which sees nothing of the world. The file that the environment
// variable VANTAGE_MADE_UP_CAMERA names says what they do, see CameraScript; it is read again for every frame.
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#define XN_NEW(type, ...) new type(__VA_ARGS__)  // the header wants them and does not bring them
#define XN_DELETE(p) delete (p)
#include <Driver/OniDriverAPI.h>

namespace {

constexpr int kColumns = 32;
constexpr int kRows = 24;
constexpr float kHorizontalFov = 0.9F;
constexpr float kVerticalFov = 0.7F;
constexpr const char* kUri = "made-up://camera";
constexpr const char* kBlindUri = "made-up://blind";

// Words in the file: gone, black, frozen, repeating, mirrored, moved, tenths, flying.
class CameraScript {
 public:
  CameraScript() {
    const char* path = std::getenv("VANTAGE_MADE_UP_CAMERA");
    std::ifstream file(path == nullptr ? "" : path);
    for (std::string word; file >> word;) words_.push_back(word);
  }
  [[nodiscard]] bool says(const char* word) const {
    for (const std::string& w : words_)
      if (w == word) return true;
    return false;
  }

 private:
  std::vector<std::string> words_;
};

template <typename T>
OniStatus put(const T& value, void* data, int* size) {
  if (*size != static_cast<int>(sizeof value)) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof value);
  return ONI_STATUS_OK;
}

class MadeUpStream final : public oni::driver::StreamBase {
 public:
  explicit MadeUpStream(bool blind) : blind_(blind), mirrored_(CameraScript().says("mirrored") ? TRUE : FALSE) {}
  ~MadeUpStream() override { MadeUpStream::stop(); }

  OniStatus start() override {
    if (thread_.joinable()) return ONI_STATUS_OK;
    running_ = true;
    thread_ = std::thread([this] { run(); });
    return ONI_STATUS_OK;
  }
  void stop() override {
    running_ = false;
    if (thread_.joinable()) thread_.join();
  }

  OniBool isPropertySupported(int id) override {
    return id == ONI_STREAM_PROPERTY_VIDEO_MODE || id == ONI_STREAM_PROPERTY_HORIZONTAL_FOV ||
           id == ONI_STREAM_PROPERTY_VERTICAL_FOV || id == ONI_STREAM_PROPERTY_MIRRORING;
  }
  OniStatus getProperty(int id, void* data, int* size) override {
    if (id == ONI_STREAM_PROPERTY_VIDEO_MODE) return put(mode_, data, size);
    if (id == ONI_STREAM_PROPERTY_HORIZONTAL_FOV) return put(blind_ ? 0.0F : kHorizontalFov, data, size);
    if (id == ONI_STREAM_PROPERTY_VERTICAL_FOV) return put(blind_ ? 0.0F : kVerticalFov, data, size);
    if (id == ONI_STREAM_PROPERTY_MIRRORING) return put(mirrored_, data, size);
    return ONI_STATUS_NOT_SUPPORTED;
  }
  OniStatus setProperty(int id, const void* data, int size) override {
    if (id == ONI_STREAM_PROPERTY_VIDEO_MODE && size == static_cast<int>(sizeof mode_)) {
      std::memcpy(&mode_, data, sizeof mode_);
      return ONI_STATUS_OK;
    }
    // A camera that will not be told.
    return id == ONI_STREAM_PROPERTY_MIRRORING ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }

 private:
  void run() {
    unsigned frames = 0;
    bool wasGone = false;
    while (running_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      const CameraScript script;
      // The stream of a camera that was unplugged stays silent for ever.
      wasGone = wasGone || script.says("gone");
      if (wasGone || script.says("frozen")) continue;
      OniFrame* frame = getServices().acquireFrame();
      if (frame == nullptr) continue;
      if (!script.says("repeating")) ++frames;
      fill(*frame, script, frames);
      frame->frameIndex = static_cast<int>(frames);
      frame->timestamp = 10'000ULL * frames;
      raiseNewFrame(frame);
      getServices().releaseFrame(frame);
    }
  }

  // A plane that lies askew, with noise of a millimetre.
  void fill(OniFrame& frame, const CameraScript& script, unsigned frames) const {
    auto* depths = static_cast<std::uint16_t*>(frame.data);
    const int perMillimetre = mode_.pixelFormat == ONI_PIXEL_FORMAT_DEPTH_100_UM ? 10 : 1;
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        const int noise = static_cast<int>((frames * 7U + static_cast<unsigned>(x * 5 + y * 3)) % 3U) - 1;
        int depth = 600 + 4 * x + 2 * y + noise + (script.says("moved") ? 50 : 0);
        // Every fourth frame shows something in between, the corner nothing.
        if (script.says("flying") && (frames + static_cast<unsigned>(x)) % 4U == 0U) depth += 200;
        if (script.says("black") || (x == 31 && y == 23)) depth = 0;
        depths[y * kColumns + (mirrored_ == TRUE ? kColumns - 1 - x : x)] =
            static_cast<std::uint16_t>(depth * perMillimetre);
      }
    }
    frame.videoMode = mode_;
    frame.sensorType = ONI_SENSOR_DEPTH;
    frame.width = kColumns;
    frame.height = kRows;
    frame.stride = 2 * kColumns;
    frame.dataSize = 2 * kColumns * kRows;
    frame.croppingEnabled = FALSE;
    frame.cropOriginX = frame.cropOriginY = 0;
  }

  bool blind_;
  OniBool mirrored_;
  OniVideoMode mode_{ONI_PIXEL_FORMAT_DEPTH_1_MM, kColumns, kRows, 30};
  std::thread thread_;
  std::atomic<bool> running_{false};
};

class MadeUpDevice final : public oni::driver::DeviceBase {
 public:
  explicit MadeUpDevice(bool blind) : blind_(blind) {
    modes_[0] = {ONI_PIXEL_FORMAT_DEPTH_1_MM, kColumns, kRows, 30};
    modes_[1] = {ONI_PIXEL_FORMAT_DEPTH_100_UM, kColumns, kRows, 30};
    sensor_ = {ONI_SENSOR_DEPTH, CameraScript().says("tenths") ? 2 : 1, modes_.data()};
  }
  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override {
    *sensors = &sensor_;
    *count = 1;
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType type) override {
    return type == ONI_SENSOR_DEPTH ? new MadeUpStream(blind_) : nullptr;
  }
  void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }
  OniBool isPropertySupported(int id) override { return id == ONI_DEVICE_PROPERTY_SERIAL_NUMBER; }
  OniStatus getProperty(int id, void* data, int* size) override {
    constexpr std::array<char, 5> kSerial{"0815"};
    if (id != ONI_DEVICE_PROPERTY_SERIAL_NUMBER || *size < static_cast<int>(kSerial.size()))
      return ONI_STATUS_NOT_SUPPORTED;
    std::memcpy(data, kSerial.data(), kSerial.size());
    *size = static_cast<int>(kSerial.size());
    return ONI_STATUS_OK;
  }

 private:
  bool blind_;
  std::array<OniVideoMode, 2> modes_{};
  OniSensorInfo sensor_{};
};

OniDeviceInfo infoOf(const char* uri, const char* name) {
  OniDeviceInfo info{};
  std::snprintf(info.uri, sizeof info.uri, "%s", uri);
  std::snprintf(info.vendor, sizeof info.vendor, "Made-up");
  std::snprintf(info.name, sizeof info.name, "%s", name);
  return info;
}

class MadeUpDriver final : public oni::driver::DriverBase {
 public:
  using DriverBase::DriverBase;

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback changed, void* cookie) override {
    DriverBase::initialize(connected, disconnected, changed, cookie);
    deviceConnected(&blind_);
    watch_ = std::thread([this] { watch(); });
    while (!looked_) std::this_thread::yield();
    return ONI_STATUS_OK;
  }
  oni::driver::DeviceBase* deviceOpen(const char* uri, const char* /*mode*/) override {
    if (std::strcmp(uri, kUri) == 0 && !connected_) return nullptr;
    return new MadeUpDevice(std::strcmp(uri, kBlindUri) == 0);
  }
  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }
  OniStatus tryDevice(const char* /*uri*/) override { return ONI_STATUS_ERROR; }
  void shutdown() override {
    quit_ = true;
    if (watch_.joinable()) watch_.join();
  }

 private:
  // Plugs the camera in and out as the script says.
  void watch() {
    while (!quit_) {
      const bool connected = !CameraScript().says("gone");
      if (connected != connected_) {
        connected_ = connected;
        if (connected)
          deviceConnected(&camera_);
        else
          deviceDisconnected(&camera_);
      }
      looked_ = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  OniDeviceInfo blind_ = infoOf(kBlindUri, "Blind Camera");
  OniDeviceInfo camera_ = infoOf(kUri, "Depth Camera");
  std::atomic<bool> connected_{false};
  std::atomic<bool> looked_{false};
  std::atomic<bool> quit_{false};
  std::thread watch_;
};

}  // namespace

ONI_EXPORT_DRIVER(MadeUpDriver)
