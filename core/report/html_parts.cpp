#include "report/html_parts.h"

#include <cstdint>
#include <cstdio>

#include "report/svg_chart.h"

namespace vantage {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

}  // namespace

std::string decimalText(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string htmlCell(const std::string& html) {
  return "<td>" + html + "</td>";
}

std::string htmlRow(const std::vector<std::string>& cells, std::string_view tag) {
  std::string html = "<tr>";
  for (const std::string& text : cells)
    html.append("<").append(tag).append(">").append(text).append("</").append(tag).append(">");
  return html + "</tr>\n";
}

std::string pictureHtml(const ReportPicture& picture) {
  const std::string caption = escapedHtml(picture.caption);
  return "<figure><img alt=\"" + caption + "\" src=\"data:image/png;base64," + base64(picture.png) + "\"><figcaption>" +
         caption + "</figcaption></figure>\n";
}

std::string picturesHtml(const std::vector<ReportPicture>& pictures) {
  if (pictures.empty()) return {};
  std::string html = "<div class=\"pictures\">\n";
  for (const ReportPicture& picture : pictures) html += pictureHtml(picture);
  return html + "</div>\n";
}

}  // namespace vantage
