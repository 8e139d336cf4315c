#include "core/io/foreign/usd/usda_layer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/base/types.h"
#include "core/io/text/file_bytes.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

using ValueKind = UsdaValue::Kind;

constexpr size_t kMostUsdaNumbers = 48'000'000;  // of a layer

bool is_usda_space(char c) { return is_blank(c) || is_line_end(c); }
bool is_usda_digit(char c) { return c >= '0' && c <= '9'; }

// Names with namespaces and suffixes, types with brackets; letters beyond ASCII, too.
bool is_name_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_usda_digit(c) || c == '_' ||
         c == ':' || c == '.' || c == '!' || static_cast<unsigned char>(c) >= 128;
}

bool is_list_op(std::string_view word) {
  return word == "prepend" || word == "append" || word == "add" || word == "delete" ||
         word == "reorder";
}

class UsdaParser {
 public:
  UsdaParser(const std::string& path, std::string_view bytes, const XmlLimits& limits)
      : m_path(path), m_bytes(bytes), m_limits(limits) {}

  UsdaSpec read() {
    if (!m_bytes.starts_with("#usda ")) fail("begins without \"#usda\"; accepted: USD as text");
    UsdaSpec root;
    if (next() == '(') read_metadata(root.metadata);
    while (next()) {
      const std::string word = name();
      if (word == "reorder")
        name(), expect('='), skip_value();
      else
        root.children.push_back(prim(word));
    }
    index_children(root);
    return root;
  }
  size_t num_elements() const { return m_num_elements; }

 private:
  [[noreturn]] void fail(const Sentence& why) const {
    const auto end = m_bytes.begin() + static_cast<std::ptrdiff_t>(std::min(m_at, m_bytes.size()));
    bad_file(m_path, "line %1: %2", 1 + std::count(m_bytes.begin(), end, '\n'), why);
  }

  void count_element() {
    if (++m_num_elements > m_limits.max_elements) fail("too many elements");
  }

  // The next character that is no space and no comment; 0 at the end.
  char next() {
    while (m_at < m_bytes.size()) {
      const char c = m_bytes[m_at];
      if (c == '#' || m_bytes.substr(m_at, 2) == "//")
        m_at = std::min(m_bytes.find('\n', m_at), m_bytes.size());
      else if (m_bytes.substr(m_at, 2) == "/*")
        skip_comment();
      else if (is_usda_space(c) || c == ';')
        ++m_at;
      else
        return c;
    }
    return 0;
  }
  void skip_comment() {
    const size_t end = m_bytes.find("*/", m_at + 2);
    if (end == std::string_view::npos) fail("a comment without its end");
    m_at = end + 2;
  }

  bool take(char c) {
    if (next() != c) return false;
    ++m_at;
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(say("\"%1\" is missing", std::string(1, c)));
  }

  std::string name() {
    next();
    const size_t begin = m_at;
    while (m_at < m_bytes.size() && is_name_char(m_bytes[m_at])) ++m_at;
    if (m_at == begin) fail("a name is missing");
    std::string out(m_bytes.substr(begin, m_at - begin));
    // Types of arrays.
    if (m_bytes.substr(m_at, 2) == "[]") out += "[]", m_at += 2;
    return out;
  }

  // Up to the closing mark, which may be escaped. @param mark  one character, or three of it.
  std::string until(const std::string& mark, bool escapes) {
    m_at += mark.size();
    std::string out;
    while (m_bytes.substr(m_at, mark.size()) != mark) {
      if (escapes && m_at + 1 < m_bytes.size() && m_bytes[m_at] == '\\') ++m_at;
      if (m_at >= m_bytes.size()) fail(say("%1 without its end", mark));
      out += m_bytes[m_at++];
    }
    m_at += mark.size();
    return out;
  }
  std::string quoted_text() {
    const char c = next();
    if (c != '"' && c != '\'') fail("a text in quotes is missing");
    const std::string three(3, c);
    return until(m_bytes.substr(m_at, 3) == three ? three : std::string(1, c), true);
  }
  std::string asset() { return until(m_bytes.substr(m_at, 3) == "@@@" ? "@@@" : "@", false); }

  void number(UsdaValue& out) {
    const size_t begin = m_at;
    const auto goes_on = [](char c) {
      return is_usda_digit(c) || c == '.' || c == '+' || c == '-' || (c >= 'a' && c <= 'z') ||
             c == 'E';
    };
    while (m_at < m_bytes.size() && goes_on(m_bytes[m_at])) ++m_at;
    const auto value = number_from(m_bytes.substr(begin, m_at - begin));
    if (!value) fail(say("\"%1\" is no number", std::string(m_bytes.substr(begin, m_at - begin))));
    if (++m_num_numbers > kMostUsdaNumbers) fail("too many numbers");
    out.numbers.push_back(*value);
  }

  void word(UsdaValue& out) {
    std::string found = name();
    if (found == "inf" || found == "nan")
      out.numbers.push_back(found == "inf" ? kInfinity : std::nan(""));
    else if (found == "None")
      out.blocks = true;
    else
      out.words.emplace_back(ValueKind::Word, std::move(found));
  }

  void value(UsdaValue& out, int depth = 0) {
    if (depth > m_limits.max_depth) fail("nested too deeply");
    switch (const char c = next()) {
      case '"':
      case '\'':
        out.words.emplace_back(ValueKind::Text, quoted_text());
        return;
      case '@':
        out.words.emplace_back(ValueKind::Asset, asset());
        return value_of_asset(out);
      case '<':
        out.words.emplace_back(ValueKind::Path, until(">", false));
        return;
      case '(':
      case '[':
        ++m_at;
        return items(c == '(' ? ')' : ']', out, depth);
      case '{':
        ++m_at;
        return dictionary(out, depth);
      default:
        if (is_usda_digit(c) || c == '-' || c == '+' || c == '.') return number(out);
        return word(out);
    }
  }

  // "@layer@</prim>": one target.
  void value_of_asset(UsdaValue& out) {
    if (next() == '<') out.words.emplace_back(ValueKind::Path, until(">", false));
  }

  void items(char close, UsdaValue& out, int depth) {
    while (!take(close)) {
      value(out, depth + 1);
      // Layers and references may have offsets in time.
      if (next() == '(' && !out.words.empty() &&
          (out.words.back().first == ValueKind::Asset || out.words.back().first == ValueKind::Path))
        skip_metadata();
      if (!take(',') && next() != close) fail(say("\"%1\" is missing", std::string(1, close)));
    }
  }

  // "type name = value", or "time: value".
  void dictionary(UsdaValue& out, int depth) {
    while (!take('}')) {
      const char c = next();
      if (c == '"' || c == '\'' || c == '<' || is_usda_digit(c) || c == '-' || c == '.') {
        UsdaValue key;
        value(key, depth + 1);
        if (!take(':')) expect('=');
        out.words.emplace_back(ValueKind::Key, key.words.empty() ? "" : key.words[0].second);
      } else {
        std::string key = name();
        // A type stands before the key.
        if (const char k = next(); k == '"' || k == '\'')
          key = quoted_text();
        else if (k != '=')
          key = name();
        expect('=');
        out.words.emplace_back(ValueKind::Key, std::move(key));
      }
      value(out, depth + 1);
      take(',');
    }
  }

  void skip_value() {
    UsdaValue ignored;
    value(ignored);
  }
  void skip_metadata() {
    std::vector<UsdaEntry> ignored;
    read_metadata(ignored);
  }

  size_t line_here() {
    // Counted on from the last one, so that all of them cost one pass.
    m_line +=
        static_cast<size_t>(std::count(m_bytes.begin() + static_cast<std::ptrdiff_t>(m_last),
                                       m_bytes.begin() + static_cast<std::ptrdiff_t>(m_at), '\n'));
    m_last = m_at;
    return m_line;
  }

  void read_metadata(std::vector<UsdaEntry>& out) {
    expect('(');
    while (!take(')')) {
      const char c = next();
      if (c == '"' || c == '\'') {  // a comment
        quoted_text();
        continue;
      }
      count_element();
      UsdaEntry entry;
      entry.line = line_here();
      entry.name = name();
      if (is_list_op(entry.name) && next() != '=') entry.op = entry.name, entry.name = name();
      if (take('=')) value(entry.value), entry.has_value = true;
      if (next() == '(') skip_metadata();  // an offset in time
      out.push_back(std::move(entry));
    }
  }

  UsdaSpec prim(const std::string& specifier) {
    count_element();
    UsdaSpec out;
    if (specifier == "over")
      out.specifier = UsdaSpec::Specifier::Over;
    else if (specifier == "class")
      out.specifier = UsdaSpec::Specifier::Class;
    else if (specifier != "def")
      fail(say("\"%1\"; accepted: def, over, class", specifier));
    out.line = line_here();
    if (const char c = next(); c != '"' && c != '\'') out.type = name();
    out.name = quoted_text();
    if (out.name.empty() || out.name.find('/') != std::string::npos)
      fail(say("\"%1\" is no name of a prim", out.name));
    read_content(out);
    return out;
  }

  // "(metadata) { properties and prims }".
  void read_content(UsdaSpec& out) {
    if (++m_depth > m_limits.max_depth) fail("nested too deeply");
    if (next() == '(') read_metadata(out.metadata);
    expect('{');
    while (!take('}')) {
      const std::string word = name();
      if (word == "def" || word == "over" || word == "class")
        out.children.push_back(prim(word));
      else if (word == "variantSet")
        read_variants(out);
      else
        read_property(word, out);
    }
    index_children(out);
    --m_depth;
  }

  void read_variants(UsdaSpec& out) {
    const std::string set = quoted_text();
    expect('=');
    expect('{');
    while (!take('}')) {
      count_element();
      UsdaSpec variant;
      variant.specifier = UsdaSpec::Specifier::Over;
      variant.line = line_here();
      variant.name = set + "=" + quoted_text();
      read_content(variant);
      out.variants.push_back(std::move(variant));
    }
  }

  void read_property(std::string word, UsdaSpec& out) {
    count_element();
    UsdaEntry entry;
    entry.line = line_here();
    if (is_list_op(word)) entry.op = word, word = name();
    // The order of prims or properties says nothing about the scene.
    if (entry.op == "reorder" && (word == "nameChildren" || word == "properties"))
      return expect('='), skip_value();
    while (word == "custom" || word == "uniform" || word == "varying" || word == "config")
      word = name();
    if (is_list_op(word)) entry.op = word, word = name();
    entry.type = word;
    entry.name = name();
    if (take('=')) value(entry.value), entry.has_value = true;
    if (next() == '(') skip_metadata();
    out.properties.push_back(std::move(entry));
  }

  void index_children(UsdaSpec& spec) const {
    const auto name_of = [&](size_t i) -> const std::string& { return spec.children[i].name; };
    spec.by_name.resize(spec.children.size());
    std::iota(spec.by_name.begin(), spec.by_name.end(), size_t{0});
    std::stable_sort(spec.by_name.begin(), spec.by_name.end(),
                     [&](size_t a, size_t b) { return name_of(a) < name_of(b); });
    for (size_t i = 1; i < spec.by_name.size(); ++i)
      if (name_of(spec.by_name[i - 1]) == name_of(spec.by_name[i]))
        bad_file(m_path, "line %1: \"%2\"; accepted: a name that no prim beside it has",
                 spec.children[spec.by_name[i]].line, name_of(spec.by_name[i]));
  }

  const std::string& m_path;
  std::string_view m_bytes;
  XmlLimits m_limits;
  size_t m_at = 0, m_last = 0, m_line = 1;
  size_t m_num_elements = 0, m_num_numbers = 0;
  int m_depth = 0;
};

}  // namespace

const std::string* UsdaValue::first(Kind kind) const {
  const auto it =
      std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.first == kind; });
  return it == words.end() ? nullptr : &it->second;
}

const UsdaSpec* UsdaSpec::child(std::string_view its_name) const {
  const auto at =
      std::lower_bound(by_name.begin(), by_name.end(), its_name,
                       [&](size_t i, std::string_view n) { return children[i].name < n; });
  return at == by_name.end() || children[*at].name != its_name ? nullptr : &children[*at];
}

const UsdaEntry* find_entry(const std::vector<UsdaEntry>& entries, std::string_view name) {
  const auto it = std::find_if(entries.rbegin(), entries.rend(), [&](const UsdaEntry& entry) {
    return entry.name == name && entry.has_value;
  });
  return it == entries.rend() ? nullptr : &*it;
}

UsdaLayer read_usda_layer(const std::string& path, const XmlLimits& limits) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) bad_file(path, "is no file");
  const auto bytes = file_bytes(path, limits.max_bytes);
  if (!bytes)
    bad_file(path, "cannot be read, or is larger than the %1 bytes left", limits.max_bytes);
  if (bytes->starts_with("PXR-USDC") || bytes->starts_with("PK"))
    bad_file(path, "is binary USD; accepted: USD as text (usdcat %1 -o scene.usda)", path);
  if (!is_utf8(*bytes)) bad_file(path, "is not in UTF-8; accepted: USD as text");
  UsdaParser parser(path, *bytes, limits);
  UsdaLayer out;
  out.path = path;
  out.root = parser.read();
  out.num_bytes = bytes->size();
  out.num_elements = parser.num_elements();
  return out;
}

}  // namespace trivet
