#include "io/depth_png.h"

#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxJsonBytes = 1U << 20;
constexpr double kMostFocal = 1e6;  // [pixels]

struct Depth {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::uint16_t> counts;
};

struct Intrinsics {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  double perMillimetre = 1.0;  // counts
};

// What libpng reads from and what it complains of.
struct PngSource {
  std::string_view bytes;
  std::size_t at = 0;
  std::string complaint;
};

void readSome(png_structp png, png_bytep to, png_size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (count > source->bytes.size() - source->at) png_error(png, "it ends early");
  std::memcpy(to, source->bytes.data() + source->at, count);
  source->at += count;
}

void complain(png_structp png, png_const_charp what) {
  static_cast<PngSource*>(png_get_error_ptr(png))->complaint = what;
  png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*what*/) {}

class PngReader {
 public:
  explicit PngReader(const FileBytes& file) : path_(file.path()) {
    source_.bytes = file.text();
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, complain, ignore);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw InvalidInput(path_ + ": there is no memory to read the picture");
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Depth read() {
    Depth depth;
    if (!tryHead()) fail();
    const png_uint_32 width = png_get_image_width(png_, info_);
    const png_uint_32 height = png_get_image_height(png_, info_);
    if (png_get_bit_depth(png_, info_) != 16 || png_get_color_type(png_, info_) != PNG_COLOR_TYPE_GRAY)
      throw InvalidInput(path_ + ": is a picture of " + std::to_string(int{png_get_bit_depth(png_, info_)}) +
                         " bits per channel, not depth: expected a grey PNG of 16 bits");
    if (width < 2 || height < 2 || width > kMaxGridCells / height)
      throw InvalidInput(path_ + ": has " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels, expected 2 x 2 up to " + std::to_string(kMaxGridCells) + " in all");
    depth.rows = height;
    depth.columns = width;
    depth.counts.resize(depth.rows * depth.columns);
    std::vector<png_bytep> rows(height);
    for (std::size_t r = 0; r < rows.size(); ++r)
      rows[r] = reinterpret_cast<png_bytep>(depth.counts.data() + r * depth.columns);
    if (!tryRows(rows.data())) fail();
    return depth;
  }

 private:
  // libpng leaves by longjmp: nothing with a destructor may live in these.
  bool tryHead() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, &source_, readSome);
    png_read_info(png_, info_);
    png_set_swap(png_);
    png_set_interlace_handling(png_);
    return true;
  }
  bool tryRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  [[noreturn]] void fail() const {
    throw InvalidInput(path_ + ": the picture cannot be read: " + source_.complaint +
                       "; wait until it is whole or save it again");
  }

  const std::string& path_;
  PngSource source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

// Reads what it needs and knows no other fields: vendors write more.
class IntrinsicsReader {
 public:
  IntrinsicsReader(const nlohmann::json& document, std::string path) : path_(std::move(path)) {
    requireObject(document);
    top_ = &document;
    inner_ = &document;
    if (const auto it = document.find("intrinsics"); it != document.end() && it->is_object()) inner_ = &*it;
  }

  Intrinsics read(std::size_t columns, std::size_t rows) const {
    Intrinsics camera;
    if (!readMatrix(camera)) {
      camera.fx = number({"fx"});
      camera.fy = number({"fy"});
      camera.cx = number({"cx", "ppx"});
      camera.cy = number({"cy", "ppy"});
    }
    if (!(camera.fx > 0.0 && camera.fx < kMostFocal && camera.fy > 0.0 && camera.fy < kMostFocal))
      throw InvalidInput(path_ + ": fx and fy are no focal lengths, expected pixels above 0");
    if (!(std::abs(camera.cx) < kMostFocal && std::abs(camera.cy) < kMostFocal))
      throw InvalidInput(path_ + ": cx and cy are no pixels");
    const double scale = number({"depth_scale"});
    if (!(scale > 0.0 && std::isfinite(scale)))
      throw InvalidInput(path_ + ": depth_scale is not above 0, expected the counts per metre");
    camera.perMillimetre = (scale >= 1.0 ? scale : 1.0 / scale) / 1000.0;
    requireSize("width", columns);
    requireSize("height", rows);
    return camera;
  }

 private:
  void requireObject(const nlohmann::json& document) const {
    if (!document.is_object()) throw InvalidInput(path_ + ": is no JSON object, expected the intrinsics of a camera");
  }

  [[nodiscard]] const nlohmann::json* find(const char* key) const {
    for (const nlohmann::json* object : {inner_, top_})
      if (const auto it = object->find(key); it != object->end()) return &*it;
    return nullptr;
  }

  [[nodiscard]] double number(std::initializer_list<const char*> keys) const {
    for (const char* key : keys)
      if (const nlohmann::json* value = find(key); value != nullptr && value->is_number()) return value->get<double>();
    throw InvalidInput(path_ + ": has no number '" + *keys.begin() +
                       "', expected fx, fy, cx, cy in pixels and depth_scale in counts per metre");
  }

  bool readMatrix(Intrinsics& camera) const {
    for (const char* key : {"K", "camera_matrix", "intrinsic_matrix"}) {
      const nlohmann::json* value = find(key);
      if (value == nullptr) continue;
      std::vector<double> n;
      append(*value, n);
      if (n.size() != 9) throw InvalidInput(path_ + ": '" + key + "' is no matrix of nine numbers");
      const bool byColumn = n[2] == 0.0 && n[5] == 0.0;
      camera = {n[0], n[4], byColumn ? n[6] : n[2], byColumn ? n[7] : n[5]};
      return true;
    }
    return false;
  }

  static void append(const nlohmann::json& value, std::vector<double>& numbers) {
    if (value.is_number() && numbers.size() < 16) numbers.push_back(value.get<double>());
    if (value.is_array())
      for (const auto& item : value)
        if (item.is_number() || item.is_array()) append(item, numbers);
  }

  void requireSize(const char* key, std::size_t pixels) const {
    const nlohmann::json* value = find(key);
    if (value == nullptr || !value->is_number()) return;
    if (value->get<double>() != static_cast<double>(pixels))
      throw InvalidInput(path_ + ": says '" + key + "' " + value->dump() + ", but the picture has " +
                         std::to_string(pixels) + ": these are the intrinsics of another picture");
  }

  std::string path_;
  const nlohmann::json* top_ = nullptr;
  const nlohmann::json* inner_ = nullptr;
};

Intrinsics readIntrinsics(const std::string& path, const Depth& depth) {
  const std::string beside = intrinsicsBeside(path);
  if (beside.empty())
    throw InvalidInput(path + ": has no intrinsics beside it: expected " + fs::path(path).stem().string() +
                       ".json with fx, fy, cx, cy in pixels and depth_scale in counts per metre");
  const FileBytes bytes(beside, kMaxJsonBytes);
  const nlohmann::json document = parseJson(std::string(bytes.text()), beside);
  return IntrinsicsReader(document, beside).read(depth.columns, depth.rows);
}

}  // namespace

std::string intrinsicsBeside(const std::string& path) {
  const fs::path picture(path);
  fs::path own = picture;
  own.replace_extension(".json");
  const std::array<fs::path, 4> places{own, fs::path(path + ".json"), picture.parent_path() / "intrinsics.json",
                                       picture.parent_path() / "camera.json"};
  for (const fs::path& place : places) {
    std::error_code missing;
    if (fs::is_regular_file(place, missing)) return place.string();
  }
  return {};
}

GridFile readDepthPng(const std::string& path) {
  const Depth depth = PngReader(FileBytes(path)).read();
  const Intrinsics camera = readIntrinsics(path, depth);
  std::vector<Vec3> points(depth.counts.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (depth.counts[i] == 0) continue;
    const double z = depth.counts[i] / camera.perMillimetre;
    const double u = static_cast<double>(i % depth.columns) - camera.cx;
    const double v = static_cast<double>(i / depth.columns) - camera.cy;
    points[i] = Vec3(u * z / camera.fx, v * z / camera.fy, z);
  }
  GridFile file;
  file.samples = gridOf(depth.rows, depth.columns, std::move(points), path);
  file.unit = 1.0;
  file.ofCamera = true;
  return file;
}

}  // namespace vantage
