#include "osmesa/osmesa_window.h"

#include <GL/osmesa.h>

#include <array>
#include <utility>

#include "vtk/context_window.h"

namespace vantage {
namespace {

class OsmesaContext final : public DrawingContext {
 public:
  OsmesaContext() = default;
  ~OsmesaContext() override { OsmesaContext::release(); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  bool makeCurrent() override {
    if (isCurrent()) return true;
    if (context_ == nullptr) context_ = make();
    return context_ != nullptr &&
           OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
  }
  bool isCurrent() const override { return context_ != nullptr && OSMesaGetCurrentContext() == context_; }
  void release() override {
    if (context_ != nullptr) OSMesaDestroyContext(std::exchange(context_, nullptr));
  }

 private:
  static OSMesaContext make() {
    constexpr std::array kAttributes{OSMESA_FORMAT,
                                     static_cast<int>(OSMESA_RGBA),
                                     OSMESA_DEPTH_BITS,
                                     24,
                                     OSMESA_STENCIL_BITS,
                                     8,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     2,
                                     0};
    return OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  }

  static constexpr int kSide = 16;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4UL * kSide * kSide> buffer_{};
};

}  // namespace

OffscreenMaker osmesaWindows() {
  return [] { return windowIn(std::make_unique<OsmesaContext>()); };
}

}  // namespace vantage
