#include "devices/openni2_camera.h"

#include <OpenNI.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// The library's own words, without line ends.
std::string lastWords() {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text.empty() ? std::string("it does not say why") : text;
}

// Puts the working directory right at the end.
class WorkingFolder {
 public:
  WorkingFolder() : folder_(::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)) {}
  ~WorkingFolder() {
    if (folder_ < 0) return;
    static_cast<void>(::fchdir(folder_) == 0);
    ::close(folder_);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  int folder_;
};

// OpenNI2 is one for the whole process. It is shut down when every stream and every device is closed.
class Library {
 public:
  Library() {
    const WorkingFolder stays;
    if (openni::OpenNI::initialize() == openni::STATUS_OK) return;
    const std::string why = lastWords();
    openni::OpenNI::shutdown();
    throw DeviceError("OpenNI2 cannot be started: " + why +
                      ". Look whether the camera's driver is whole, and whether another program uses it");
  }
  ~Library() { openni::OpenNI::shutdown(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

void startLibrary() {
  static const Library kLibrary;
}

// Hears on a thread of the driver that a device is gone.
class Disconnection final : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  explicit Disconnection(std::string uri) : uri_(std::move(uri)) {
    openni::OpenNI::addDeviceDisconnectedListener(this);
  }
  ~Disconnection() override { openni::OpenNI::removeDeviceDisconnectedListener(this); }
  Disconnection(const Disconnection&) = delete;
  Disconnection& operator=(const Disconnection&) = delete;

  void onDeviceDisconnected(const openni::DeviceInfo* device) override {
    if (uri_ == device->getUri()) gone_ = true;
  }
  [[nodiscard]] bool gone() const { return gone_; }

 private:
  std::string uri_;
  std::atomic<bool> gone_{false};
};

// Millimetres per count of a depth format; nothing for what is no depth.
std::optional<double> unitOf(openni::PixelFormat format) {
  if (format == openni::PIXEL_FORMAT_DEPTH_1_MM) return 1.0;
  if (format == openni::PIXEL_FORMAT_DEPTH_100_UM) return 0.1;
  return std::nullopt;
}

std::string sizesOf(const openni::Array<openni::VideoMode>& modes) {
  std::vector<std::string> sizes;
  for (int i = 0; i < modes.getSize(); ++i) {
    const std::string size =
        std::to_string(modes[i].getResolutionX()) + " x " + std::to_string(modes[i].getResolutionY());
    if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) sizes.push_back(size);
  }
  std::string text;
  for (const std::string& size : sizes) text += (text.empty() ? "" : ", ") + size;
  return text.empty() ? "no size" : text;
}

// Of the images that will do those of the finest unit, and of these the most per second.
const openni::VideoMode* bestMode(const openni::Array<openni::VideoMode>& modes,
                                  const OpenNi2Camera::SizeTest& willDo) {
  const openni::VideoMode* best = nullptr;
  const auto worth = [](const openni::VideoMode& mode) {
    return std::pair(-unitOf(mode.getPixelFormat()).value(), mode.getFps());
  };
  for (int i = 0; i < modes.getSize(); ++i) {
    const openni::VideoMode& mode = modes[i];
    if (!unitOf(mode.getPixelFormat()) || !willDo(mode.getResolutionX(), mode.getResolutionY())) continue;
    if (best == nullptr || worth(mode) > worth(*best)) best = &mode;
  }
  return best;
}

bool same(const openni::VideoMode& a, const openni::VideoMode& b) {
  return a.getPixelFormat() == b.getPixelFormat() && a.getResolutionX() == b.getResolutionX() &&
         a.getResolutionY() == b.getResolutionY() && a.getFps() == b.getFps();
}

}  // namespace

std::vector<ListedCamera> listedCameras() {
  startLibrary();
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<ListedCamera> cameras;
  for (int i = 0; i < devices.getSize(); ++i)
    cameras.push_back({devices[i].getUri(), devices[i].getVendor(), devices[i].getName()});
  return cameras;
}

struct OpenNi2Camera::Open {
  explicit Open(const ListedCamera& camera) : disconnection(camera.uri), name(camera.vendor + " " + camera.name) {}
  // The order in which it must be closed.
  ~Open() {
    stream.stop();
    stream.destroy();
    device.close();
  }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  [[noreturn]] void fail(const std::string& what) const { throw DeviceError("depth camera " + name + ": " + what); }

  void open(const std::string& uri, const SizeTest& sizeWillDo);
  void choose(const SizeTest& sizeWillDo);
  void measure();

  Disconnection disconnection;
  std::string name;
  openni::Device device;
  openni::VideoStream stream;
  CameraModel model;
  double unit = 1.0;
  bool mirrored = false;
};

void OpenNi2Camera::Open::open(const std::string& uri, const SizeTest& sizeWillDo) {
  if (device.open(uri.c_str()) != openni::STATUS_OK)
    fail("it cannot be opened (" + lastWords() + "): is it plugged in, may you use it, and does no other program?");
  std::array<char, 256> serial{};
  int size = static_cast<int>(serial.size()) - 1;
  if (device.getProperty(openni::DEVICE_PROPERTY_SERIAL_NUMBER, serial.data(), &size) == openni::STATUS_OK &&
      serial[0] != '\0')
    name += std::string(", serial number ") + serial.data();
  if (!device.hasSensor(openni::SENSOR_DEPTH) || stream.create(device, openni::SENSOR_DEPTH) != openni::STATUS_OK)
    fail("it measures no depth: choose another camera");
  if (sizeWillDo) choose(sizeWillDo);
  measure();
  if (sizeWillDo && stream.start() != openni::STATUS_OK)
    fail("it does not begin to measure (" + lastWords() + "): unplug it, plug it in again and repeat");
}

void OpenNi2Camera::Open::choose(const SizeTest& sizeWillDo) {
  const auto& modes = stream.getSensorInfo().getSupportedVideoModes();
  const openni::VideoMode* mode = bestMode(modes, sizeWillDo);
  if (mode == nullptr)
    fail("it has images of " + sizesOf(modes) +
         " pixels, and none that fits the rays of the profile: choose the profile of this camera, or make one from it");
  // A stream that is open elsewhere can be shared as it is.
  if (!same(stream.getVideoMode(), *mode) && stream.setVideoMode(*mode) != openni::STATUS_OK)
    fail("it cannot be set to " + std::to_string(mode->getResolutionX()) + " x " +
         std::to_string(mode->getResolutionY()) + " pixels (" + lastWords() + "): does another program use it?");
  if (stream.isPropertySupported(openni::STREAM_PROPERTY_MIRRORING)) {
    static_cast<void>(stream.setMirroringEnabled(false));
    mirrored = stream.getMirroringEnabled();
  }
}

void OpenNi2Camera::Open::measure() {
  const openni::VideoMode mode = stream.getVideoMode();
  const auto millimetres = unitOf(mode.getPixelFormat());
  if (!millimetres) fail("its depths are of an unknown format: choose another camera");
  unit = *millimetres;
  model = {mode.getResolutionX(), mode.getResolutionY(), static_cast<double>(stream.getHorizontalFieldOfView()),
           static_cast<double>(stream.getVerticalFieldOfView())};
  if (!(model.horizontalFov > 0.0 && model.verticalFov > 0.0))
    fail("it says of itself that it sees 0 degrees: it cannot be used to measure with");
}

OpenNi2Camera::OpenNi2Camera(const ListedCamera& camera, const SizeTest& sizeWillDo) {
  startLibrary();
  open_ = std::make_unique<Open>(camera);
  open_->open(camera.uri, sizeWillDo);
}

OpenNi2Camera::~OpenNi2Camera() = default;

const std::string& OpenNi2Camera::name() const {
  return open_->name;
}

const CameraModel& OpenNi2Camera::model() const {
  return open_->model;
}

double OpenNi2Camera::unit() const {
  return open_->unit;
}

bool OpenNi2Camera::isGone() const {
  return open_->disconnection.gone();
}

std::optional<DepthFrame> OpenNi2Camera::next(std::chrono::milliseconds patience) {
  openni::VideoStream* streams[] = {&open_->stream};
  int ready = -1;
  // A blocking read of a camera that is gone never returns.
  const openni::Status status =
      openni::OpenNI::waitForAnyStream(streams, 1, &ready, static_cast<int>(patience.count()));
  if (status == openni::STATUS_TIME_OUT) return std::nullopt;
  openni::VideoFrameRef frame;
  if (status != openni::STATUS_OK || open_->stream.readFrame(&frame) != openni::STATUS_OK)
    open_->fail("a frame cannot be read (" + lastWords() + "): unplug it, plug it in again and repeat the scan");
  const int columns = open_->model.columns;
  const int rows = open_->model.rows;
  if (frame.getWidth() != columns || frame.getHeight() != rows ||
      frame.getStrideInBytes() < columns * static_cast<int>(sizeof(std::uint16_t)) ||
      unitOf(frame.getVideoMode().getPixelFormat()) != open_->unit)
    open_->fail("it sent a frame of " + std::to_string(frame.getWidth()) + " x " + std::to_string(frame.getHeight()) +
                " pixels, expected " + describe(open_->model) + ": has another program changed its settings?");
  DepthFrame depths;
  depths.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int y = 0; y < rows; ++y) {
    const auto* row = reinterpret_cast<const std::uint16_t*>(static_cast<const std::byte*>(frame.getData()) +
                                                             static_cast<std::ptrdiff_t>(y) * frame.getStrideInBytes());
    depths.insert(depths.end(), row, row + columns);
    if (open_->mirrored) std::reverse(depths.end() - columns, depths.end());
  }
  return depths;
}

}  // namespace vantage
