#include "cli/text.h"

#include <cstdio>

#include "base/atomic_file.h"

namespace vantage {

std::string number(double value, int decimals) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

void writeTextFile(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace vantage
