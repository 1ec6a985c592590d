#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vantage {

/// A tag of an XML document. Names are without their namespace prefix; views point into the document.
struct XmlTag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;  ///< as written: entities are not replaced
  bool opens = false;
  bool closes = false;  ///< a tag like <a/> opens and closes

  [[nodiscard]] std::string_view attribute(std::string_view key) const;
};

/// Walks over the tags of an XML document; text, comments and declarations between them are skipped. Checks that tags
/// are closed in order, so that a document that is cut off is noticed. Document types are refused.
class XmlScanner {
 public:
  /// @param file and part for messages.
  /// @throws InvalidInput when the text does not begin with a tag
  XmlScanner(std::string_view text, std::string file, std::string part);

  /// The next tag; false at the end of the document.
  /// @throws InvalidInput naming file, part and line
  [[nodiscard]] bool next(XmlTag& tag);

  /// @throws InvalidInput always: "file: part: line N: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void readTag(XmlTag& tag);
  void skipBlanks();
  [[nodiscard]] std::string_view readName();
  [[nodiscard]] std::string_view upTo(std::string_view mark);

  std::string_view text_;
  std::size_t at_ = 0;
  std::string file_;
  std::string part_;
  std::vector<std::string_view> open_;
};

/// A value with the five entities of XML replaced by their characters.
[[nodiscard]] std::string withoutEntities(std::string_view value);

}  // namespace vantage
