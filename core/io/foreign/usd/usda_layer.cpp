#include "core/io/foreign/usd/usda_layer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/base/types.h"
#include "core/io/foreign/usd/usda_text.h"
#include "core/io/text/file_bytes.h"

namespace trivet {
namespace {

using ValueKind = UsdaValue::Kind;

constexpr size_t kMostUsdaNumbers = 48'000'000;  // of a layer

bool is_list_op(std::string_view word) {
  return word == "prepend" || word == "append" || word == "add" || word == "delete" ||
         word == "reorder";
}

// Grammar of a layer: values, metadata, prims, variants, properties.
class UsdaParser {
 public:
  UsdaParser(const std::string& path, std::string_view bytes, const XmlLimits& limits)
      : m_path(path), m_bytes(bytes), m_text(path, bytes), m_limits(limits) {}

  UsdaSpec read() {
    if (!m_bytes.starts_with("#usda "))
      m_text.fail("begins without \"#usda\"; accepted: USD as text");
    UsdaSpec root;
    if (m_text.next() == '(') read_metadata(root.metadata);
    while (m_text.next()) {
      const std::string word = m_text.name();
      if (word == "reorder")
        m_text.name(), m_text.expect('='), skip_value();
      else
        root.children.push_back(prim(word));
    }
    index_children(root);
    return root;
  }
  size_t num_elements() const { return m_num_elements; }

 private:
  void count_element() {
    if (++m_num_elements > m_limits.max_elements) m_text.fail("too many elements");
  }

  void number(UsdaValue& out) {
    const double value = m_text.number();
    if (++m_num_numbers > kMostUsdaNumbers) m_text.fail("too many numbers");
    out.numbers.push_back(value);
  }

  void word(UsdaValue& out) {
    std::string found = m_text.name();
    if (found == "inf" || found == "nan")
      out.numbers.push_back(found == "inf" ? kInfinity : std::nan(""));
    else if (found == "None")
      out.blocks = true;
    else
      out.words.emplace_back(ValueKind::Word, std::move(found));
  }

  void value(UsdaValue& out, int depth = 0) {
    if (depth > m_limits.max_depth) m_text.fail("nested too deeply");
    switch (const char c = m_text.next()) {
      case '"':
      case '\'':
        out.words.emplace_back(ValueKind::Text, m_text.quoted_text());
        return;
      case '@':
        out.words.emplace_back(ValueKind::Asset, m_text.asset());
        return value_of_asset(out);
      case '<':
        out.words.emplace_back(ValueKind::Path, m_text.path());
        return;
      case '(':
      case '[':
        m_text.take(c);
        return items(c == '(' ? ')' : ']', out, depth);
      case '{':
        m_text.take(c);
        return dictionary(out, depth);
      default:
        if (is_usda_digit(c) || c == '-' || c == '+' || c == '.') return number(out);
        return word(out);
    }
  }

  // "@layer@</prim>": one target.
  void value_of_asset(UsdaValue& out) {
    if (m_text.next() == '<') out.words.emplace_back(ValueKind::Path, m_text.path());
  }

  void items(char close, UsdaValue& out, int depth) {
    while (!m_text.take(close)) {
      value(out, depth + 1);
      // Layers and references may have offsets in time.
      if (m_text.next() == '(' && !out.words.empty() &&
          (out.words.back().first == ValueKind::Asset || out.words.back().first == ValueKind::Path))
        skip_metadata();
      if (!m_text.take(',') && m_text.next() != close)
        m_text.fail(say("\"%1\" is missing", std::string(1, close)));
    }
  }

  // "type name = value", or "time: value".
  void dictionary(UsdaValue& out, int depth) {
    while (!m_text.take('}')) {
      const char c = m_text.next();
      if (c == '"' || c == '\'' || c == '<' || is_usda_digit(c) || c == '-' || c == '.') {
        UsdaValue key;
        value(key, depth + 1);
        if (!m_text.take(':')) m_text.expect('=');
        out.words.emplace_back(ValueKind::Key, key.words.empty() ? "" : key.words[0].second);
      } else {
        std::string key = m_text.name();
        // A type stands before the key.
        if (const char k = m_text.next(); k == '"' || k == '\'')
          key = m_text.quoted_text();
        else if (k != '=')
          key = m_text.name();
        m_text.expect('=');
        out.words.emplace_back(ValueKind::Key, std::move(key));
      }
      value(out, depth + 1);
      m_text.take(',');
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

  void read_metadata(std::vector<UsdaEntry>& out) {
    m_text.expect('(');
    while (!m_text.take(')')) {
      const char c = m_text.next();
      if (c == '"' || c == '\'') {  // a comment
        m_text.quoted_text();
        continue;
      }
      count_element();
      UsdaEntry entry;
      entry.line = m_text.line();
      entry.name = m_text.name();
      if (is_list_op(entry.name) && m_text.next() != '=')
        entry.op = entry.name, entry.name = m_text.name();
      if (m_text.take('=')) value(entry.value), entry.has_value = true;
      if (m_text.next() == '(') skip_metadata();  // an offset in time
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
      m_text.fail(say("\"%1\"; accepted: def, over, class", specifier));
    out.line = m_text.line();
    if (const char c = m_text.next(); c != '"' && c != '\'') out.type = m_text.name();
    out.name = m_text.quoted_text();
    if (out.name.empty() || out.name.find('/') != std::string::npos)
      m_text.fail(say("\"%1\" is no name of a prim", out.name));
    read_content(out);
    return out;
  }

  // "(metadata) { properties and prims }".
  void read_content(UsdaSpec& out) {
    if (++m_depth > m_limits.max_depth) m_text.fail("nested too deeply");
    if (m_text.next() == '(') read_metadata(out.metadata);
    m_text.expect('{');
    while (!m_text.take('}')) {
      const std::string word = m_text.name();
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
    const std::string set = m_text.quoted_text();
    m_text.expect('=');
    m_text.expect('{');
    while (!m_text.take('}')) {
      count_element();
      UsdaSpec variant;
      variant.specifier = UsdaSpec::Specifier::Over;
      variant.line = m_text.line();
      variant.name = set + "=" + m_text.quoted_text();
      read_content(variant);
      out.variants.push_back(std::move(variant));
    }
  }

  void read_property(std::string word, UsdaSpec& out) {
    count_element();
    UsdaEntry entry;
    entry.line = m_text.line();
    if (is_list_op(word)) entry.op = word, word = m_text.name();
    // The order of prims or properties says nothing about the scene.
    if (entry.op == "reorder" && (word == "nameChildren" || word == "properties"))
      return m_text.expect('='), skip_value();
    while (word == "custom" || word == "uniform" || word == "varying" || word == "config")
      word = m_text.name();
    if (is_list_op(word)) entry.op = word, word = m_text.name();
    entry.type = word;
    entry.name = m_text.name();
    if (m_text.take('=')) value(entry.value), entry.has_value = true;
    if (m_text.next() == '(') skip_metadata();
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
  UsdaText m_text;
  XmlLimits m_limits;
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
