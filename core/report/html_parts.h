#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A picture for the report.
struct ReportPicture {
  std::string caption;
  std::string png;  ///< the bytes of a PNG file
};

/// A number with so many decimals.
[[nodiscard]] std::string decimalText(double value, int decimals);

/// A cell and a row of a table. What is put in is HTML already.
[[nodiscard]] std::string htmlCell(const std::string& html);
[[nodiscard]] std::string htmlRow(const std::vector<std::string>& cells, std::string_view tag = "td");

/// A picture with its caption, which needs no other file.
[[nodiscard]] std::string pictureHtml(const ReportPicture& picture);
/// Several side by side; nothing for none.
[[nodiscard]] std::string picturesHtml(const std::vector<ReportPicture>& pictures);

}  // namespace vantage
