#include <GL/osmesa.h>

#include <array>
#include <cstring>
#include <utility>

// GLEW, which VTK loads OpenGL with, asks GLX for the functions of OpenGL. A program that exports the functions below
// gives it those of OSMesa instead, and answers what GLEW wants to know of GLX itself as a server without extensions
// would: some of it GLEW calls by name, some by address.

// NOLINTBEGIN(readability-identifier-naming): the names are those of GLX
extern "C" {

using GlxFunction = void (*)();

void* glXGetCurrentDisplay() {
  static int display = 0;
  return &display;
}

int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

const char* glXGetClientString(void*, int) {
  return "";
}

const char* glXQueryExtensionsString(void*, int) {
  return "";
}

GlxFunction glXGetProcAddressARB(const unsigned char* functionName) {
  const std::array<std::pair<const char*, GlxFunction>, 4> ours{
      {{"glXGetCurrentDisplay", reinterpret_cast<GlxFunction>(&glXGetCurrentDisplay)},
       {"glXQueryVersion", reinterpret_cast<GlxFunction>(&glXQueryVersion)},
       {"glXGetClientString", reinterpret_cast<GlxFunction>(&glXGetClientString)},
       {"glXQueryExtensionsString", reinterpret_cast<GlxFunction>(&glXQueryExtensionsString)}}};
  const auto* name = reinterpret_cast<const char*>(functionName);
  if (std::strncmp(name, "glX", 3) != 0) return OSMesaGetProcAddress(name);
  for (const auto& [known, function] : ours)
    if (std::strcmp(name, known) == 0) return function;
  return nullptr;
}

GlxFunction glXGetProcAddress(const unsigned char* functionName) {
  return glXGetProcAddressARB(functionName);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
