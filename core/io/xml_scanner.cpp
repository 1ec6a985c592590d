#include "io/xml_scanner.h"

#include <algorithm>
#include <array>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kNameEnds = " \t\r\n/>=\"'<";
// Far deeper than any mesh format nests.
constexpr std::size_t kMaxDepth = 256;
constexpr std::size_t kMaxAttributes = 256;

}  // namespace

std::string_view XmlTag::attribute(std::string_view key) const {
  for (const auto& attribute : attributes)
    if (attribute.first == key) return attribute.second;
  return {};
}

XmlScanner::XmlScanner(std::string_view text, std::string file, std::string part)
    : text_(text), file_(std::move(file)), part_(std::move(part)) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  skipBlanks();
  if (!text_.substr(at_).starts_with('<')) fail("is no XML document: it is damaged or encrypted");
}

bool XmlScanner::next(XmlTag& tag) {
  for (;;) {
    at_ = std::min(text_.find('<', at_), text_.size());
    const std::string_view rest = text_.substr(at_);
    if (rest.empty()) {
      if (!open_.empty())
        fail("the document ends, expected the end of " + inQuotes(open_.back()) + ": it is truncated");
      return false;
    }
    if (rest.starts_with("<!--")) {
      static_cast<void>(upTo("-->"));
    } else if (rest.starts_with("<![CDATA[")) {
      static_cast<void>(upTo("]]>"));
    } else if (rest.starts_with("<?")) {
      static_cast<void>(upTo("?>"));
    } else if (rest.starts_with("<!")) {
      fail("the document has a document type, which is not allowed");
    } else {
      readTag(tag);
      return true;
    }
  }
}

void XmlScanner::readTag(XmlTag& tag) {
  tag.attributes.clear();
  ++at_;
  tag.opens = at_ < text_.size() && text_[at_] != '/';
  tag.closes = !tag.opens;
  if (tag.closes) ++at_;
  const std::string_view whole = readName();
  tag.name = whole.substr(whole.find(':') + 1);
  for (skipBlanks(); at_ < text_.size() && text_[at_] != '>'; skipBlanks()) {
    if (text_[at_] == '/') {
      tag.closes = true;
      ++at_;
      continue;
    }
    const std::string_view name = readName();
    skipBlanks();
    if (at_ >= text_.size() || text_[at_] != '=') fail("the attribute " + inQuotes(name) + " has no value");
    ++at_;
    skipBlanks();
    const std::string_view quote = text_.substr(std::min(at_, text_.size()), 1);
    if (quote != "\"" && quote != "'") fail("the value of " + inQuotes(name) + " is not in quotes");
    ++at_;
    const std::string_view value = upTo(quote);
    // Declarations of namespaces keep their prefix.
    tag.attributes.emplace_back(name.starts_with("xmlns") ? name : name.substr(name.find(':') + 1), value);
    if (tag.attributes.size() > kMaxAttributes)
      fail("a tag has more than " + std::to_string(kMaxAttributes) + " attributes");
  }
  if (at_ >= text_.size()) fail("the document ends within the tag " + inQuotes(whole) + ": it is truncated");
  ++at_;
  if (tag.opens) open_.push_back(whole);
  if (open_.size() > kMaxDepth) fail("tags are nested more than " + std::to_string(kMaxDepth) + " deep");
  if (!tag.closes) return;
  if (open_.empty() || open_.back() != whole) fail("the end of " + inQuotes(whole) + " has no beginning");
  open_.pop_back();
}

void XmlScanner::skipBlanks() {
  at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
}

std::string_view XmlScanner::readName() {
  const std::size_t end = std::min(text_.find_first_of(kNameEnds, at_), text_.size());
  const std::string_view name = text_.substr(at_, end - at_);
  if (name.empty()) fail(inQuotes(text_.substr(at_, 20)) + " stands where a name was expected");
  at_ = end;
  return name;
}

std::string_view XmlScanner::upTo(std::string_view mark) {
  const std::size_t end = text_.find(mark, at_);
  if (end == std::string_view::npos) fail("the document ends, expected " + inQuotes(mark) + ": it is truncated");
  const std::string_view piece = text_.substr(at_, end - at_);
  at_ = end + mark.size();
  return piece;
}

void XmlScanner::fail(const std::string& what) const {
  const auto line =
      1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())), '\n');
  throw InvalidInput(file_ + ": " + part_ + ", line " + std::to_string(line) + ": " + what);
}

std::string withoutEntities(std::string_view value) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string text;
  while (!value.empty()) {
    const auto entity =
        std::find_if(kEntities.begin(), kEntities.end(), [&](const auto& e) { return value.starts_with(e.first); });
    text += entity == kEntities.end() ? value[0] : entity->second;
    value.remove_prefix(entity == kEntities.end() ? 1 : entity->first.size());
  }
  return text;
}

}  // namespace vantage
