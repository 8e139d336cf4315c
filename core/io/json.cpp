#include "core/io/json.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/printable.h"

namespace trivet {
namespace {

// "[json.exception.parse_error.101] parse error at line 1, column 5: what" -> from "line" on.
std::string without_prefix(const std::string& message) {
  for (const char* mark : {"parse error at ", "parse error: ", "] "}) {
    const size_t at = message.find(mark);
    if (at != std::string::npos) return message.substr(at + std::strlen(mark));
  }
  return message;
}

// The library does not say where a number overflows, only which: 'number overflow parsing '1e999''.
Sentence overflow_message(const std::string& text, const std::string& what) {
  const size_t first = what.find('\''), last = what.rfind('\'');
  if (first == std::string::npos || last <= first) return without_prefix(what);
  const std::string token = what.substr(first + 1, last - first - 1);
  const size_t at = std::min(text.find(token), text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  const size_t line_start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const size_t column = line_start == std::string::npos ? at + 1 : at - line_start;
  return say(
      "line %1, column %2: %3 is not accepted; accepted: numbers between -1.797e308 and "
      "1.797e308",
      line, column, token.substr(0, 40));
}

template <class Json>
struct Member {
  std::string key;
  Json value;
};

// The library's own builder looks through all keys of an ordered object for each new one, and takes
// a key that comes twice. Here, values wait on two stacks until their array or object ends.
template <class Json>
class JsonBuilder {
 public:
  using string_t = typename Json::string_t;

  JsonBuilder(const std::string& text, const Sentence& name, const JsonLimits& limits)
      : m_text(text), m_name(name), m_limits(limits) {}

  Json take() { return std::move(m_root); }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(typename Json::number_integer_t value) { return add(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) { return add(value); }
  bool number_float(typename Json::number_float_t value, const string_t&) { return add(value); }
  bool string(string_t& value) { return add(std::move(value)); }
  bool binary(typename Json::binary_t&) { return false; }  // no text has it
  bool start_object(std::size_t) { return enter(false, m_members.size()); }
  bool start_array(std::size_t) { return enter(true, m_items.size()); }

  bool key(string_t& key) {
    m_levels.back().key = std::move(key);
    return true;
  }

  bool end_array() {
    const auto first = m_items.begin() + static_cast<long>(m_levels.back().first);
    Json array = typename Json::array_t(std::make_move_iterator(first),
                                        std::make_move_iterator(m_items.end()));
    m_items.erase(first, m_items.end());
    m_levels.pop_back();
    return add(std::move(array));
  }

  bool end_object() {
    check_keys();
    Json object = Json::object();
    auto& members = object.template get_ref<typename Json::object_t&>();
    const auto first = m_members.begin() + static_cast<long>(m_levels.back().first);
    if constexpr (kOrdered) members.reserve(static_cast<size_t>(m_members.end() - first));
    for (auto member = first; member != m_members.end(); ++member) append(*member, members);
    m_members.erase(first, m_members.end());
    m_levels.pop_back();
    return add(std::move(object));
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) {
    constexpr int kNumberOverflow = 406;
    if (e.id == kNumberOverflow) fail(overflow_message(m_text, e.what()));
    fail(complaint_of(e));
    return false;
  }

 private:
  static constexpr bool kOrdered = std::is_same_v<Json, nlohmann::ordered_json>;

  struct Level {
    bool array;
    size_t first;  // of its values on their stack
    std::string key;
  };

  // Keys are known to differ: the ordered map itself would look for each.
  static void append(Member<Json>& member, typename Json::object_t& members) {
    if constexpr (kOrdered)
      static_cast<typename Json::object_t::Container&>(members).emplace_back(
          std::move(member.key), std::move(member.value));
    else
      members.emplace(std::move(member.key), std::move(member.value));
  }

  [[noreturn]] void fail(const Sentence& what) const { bad_input("%1: %2", m_name, what); }

  template <class T>
  bool add(T&& value) {
    if (m_levels.empty())
      m_root = std::forward<T>(value);
    else if (m_levels.back().array)
      m_items.emplace_back(std::forward<T>(value));
    else
      m_members.push_back({std::move(m_levels.back().key), Json(std::forward<T>(value))});
    return true;
  }

  bool enter(bool array, size_t first) {
    if (m_levels.size() >= m_limits.max_depth)
      fail(say("%1: nested too deep; accepted: up to %2 levels", pointer(m_levels.size()),
               m_limits.max_depth));
    m_levels.push_back({array, first, {}});
    return true;
  }

  void check_keys() {
    m_keys.clear();
    for (size_t i = m_levels.back().first; i < m_members.size(); ++i)
      m_keys.push_back(&m_members[i].key);
    const auto before = [](const std::string* a, const std::string* b) { return *a < *b; };
    const auto same = [](const std::string* a, const std::string* b) { return *a == *b; };
    std::sort(m_keys.begin(), m_keys.end(), before);
    const auto twice = std::adjacent_find(m_keys.begin(), m_keys.end(), same);
    if (twice != m_keys.end())
      fail(say("%1: this key comes twice; accepted: each key once",
               pointer(m_levels.size() - 1) + '/' + printable(pointer_token(**twice), 100)));
  }

  // The place of what the outermost levels hold last. Their values wait between those of the level
  // around them and those of the one inside.
  std::string pointer(size_t num_levels) const {
    std::string out;
    for (size_t i = 0; i < num_levels; ++i) {
      const Level& level = m_levels[i];
      out += '/';
      out += level.array ? std::to_string(index_in(i)) : pointer_token(level.key);
    }
    return printable(out, 200);
  }

  size_t index_in(size_t level) const {
    size_t end = m_items.size();
    for (size_t i = m_levels.size(); i-- > level + 1;)
      if (m_levels[i].array) end = m_levels[i].first;
    return end - m_levels[level].first;
  }

  const std::string& m_text;
  const Sentence& m_name;
  const JsonLimits& m_limits;
  Json m_root;
  std::vector<Level> m_levels;
  std::vector<Json> m_items;            // of arrays that are open
  std::vector<Member<Json>> m_members;  // of objects that are open
  std::vector<const std::string*> m_keys;
};

}  // namespace

template <class Json>
Json json_from_text(const std::string& text, const Sentence& name, const JsonLimits& limits) {
  if (text.size() > limits.max_bytes)
    bad_input("%1: %2 bytes, more than the limit of %3", name, text.size(), limits.max_bytes);
  JsonBuilder<Json> builder(text, name, limits);
  Json::sax_parse(text, &builder);
  return builder.take();
}

template <class Json>
std::optional<Json> json_if_valid(const std::string& text, const JsonLimits& limits) {
  try {
    return json_from_text<Json>(text, "", limits);
  } catch (const Error&) {
    return std::nullopt;
  }
}

template nlohmann::json json_from_text(const std::string&, const Sentence&, const JsonLimits&);
template nlohmann::ordered_json json_from_text(const std::string&, const Sentence&,
                                               const JsonLimits&);
template std::optional<nlohmann::json> json_if_valid(const std::string&, const JsonLimits&);
template std::optional<nlohmann::ordered_json> json_if_valid(const std::string&, const JsonLimits&);

std::string complaint_of(const nlohmann::detail::exception& e) {
  return printable(without_prefix(e.what()), 200);
}

std::string pointer_token(const std::string& key) {
  std::string out;
  for (char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

}  // namespace trivet
