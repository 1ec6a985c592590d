#include <GL/osmesa.h>

#include <cstring>

// GLEW, which VTK loads OpenGL with, asks GLX for the functions of OpenGL. A program that exports these two gives it
// those of OSMesa instead, and answers what GLEW wants to know of GLX itself as a server without extensions would.
namespace {

using Function = void (*)();

void* currentDisplay() {
  static int display = 0;
  return &display;
}

int queryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

const char* clientString(void*, int) {
  return "";
}

const char* extensionsString(void*, int) {
  return "";
}

Function lookUp(const char* name) {
  if (std::strncmp(name, "glX", 3) != 0) return OSMesaGetProcAddress(name);
  if (std::strcmp(name, "glXGetCurrentDisplay") == 0) return reinterpret_cast<Function>(&currentDisplay);
  if (std::strcmp(name, "glXQueryVersion") == 0) return reinterpret_cast<Function>(&queryVersion);
  if (std::strcmp(name, "glXGetClientString") == 0) return reinterpret_cast<Function>(&clientString);
  if (std::strcmp(name, "glXQueryExtensionsString") == 0) return reinterpret_cast<Function>(&extensionsString);
  return nullptr;
}

}  // namespace

extern "C" {

// NOLINTNEXTLINE(readability-identifier-naming): the name is GLX's
Function glXGetProcAddressARB(const unsigned char* name) {
  return lookUp(reinterpret_cast<const char*>(name));
}

// NOLINTNEXTLINE(readability-identifier-naming): the name is GLX's
Function glXGetProcAddress(const unsigned char* name) {
  return lookUp(reinterpret_cast<const char*>(name));
}

}  // extern "C"
