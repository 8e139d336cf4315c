#include "apps/edit/document/sentence_reader.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "apps/edit/document/sentence_patterns.h"

namespace trivet::edit {
namespace {

constexpr int kMaxDepth = 8;  // of sentences in sentences

struct Pattern {
  std::string text;
  std::vector<std::string> between;  // what is before, between and after its parts
  size_t num_letters = 0;            // of these
};

Pattern pattern_of(const char* text) {
  Pattern out{text, {""}};
  for (const char* at = text; *at; ++at) {
    if (*at == '%' && at[1] >= '1' && at[1] <= '9') {
      out.between.emplace_back();
      ++at;
    } else {
      out.between.back() += *at;
      ++out.num_letters;
    }
  }
  return out;
}

const std::vector<Pattern>& all_patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> out;
    for (const auto& some : {joining_patterns(), model_patterns(), gltf_patterns(), file_patterns(),
                             layout_patterns(), arrangement_patterns(), refusal_patterns()})
      for (const char* const text : some) out.push_back(pattern_of(text));
    std::stable_sort(out.begin(), out.end(), [](const Pattern& a, const Pattern& b) {
      return a.num_letters > b.num_letters;
    });
    return out;
  }();
  return all;
}

/// End of the part before `next`; npos: the pattern does not fit.
size_t end_of_part(const std::string& text, size_t begin, const std::string& next, bool is_last) {
  if (!is_last) return text.find(next, begin);
  const bool fits = text.size() >= begin + next.size() && text.ends_with(next);
  return fits ? text.size() - next.size() : std::string::npos;
}

bool is_in_quotes(const Pattern& pattern, size_t part) {
  const std::string &before = pattern.between[part], &after = pattern.between[part + 1];
  return (before.ends_with('"') && after.starts_with('"')) ||
         (before.ends_with('\'') && after.starts_with('\''));
}

/// Its parts; empty: it does not fit. What stands in quotes has none itself.
std::vector<std::string> parts_of(const std::string& text, const Pattern& pattern) {
  const auto& between = pattern.between;
  if (!text.starts_with(between.front())) return {};
  std::vector<std::string> out;
  size_t begin = between.front().size();
  for (size_t i = 1; i < between.size(); ++i) {
    const size_t end = end_of_part(text, begin, between[i], i + 1 == between.size());
    if (end == std::string::npos || end <= begin) return {};
    out.push_back(text.substr(begin, end - begin));
    if (is_in_quotes(pattern, i - 1) && out.back().find(between[i].front()) != std::string::npos)
      return {};
    begin = end + between[i].size();
  }
  return out;
}

/// Lengths have the decimals of the language.
std::optional<Sentence> length(const std::string& text, const std::string& next) {
  if (next != " m" && !next.starts_with(" m ")) return std::nullopt;
  Sentence out;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  out.number = value;
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && in_english(out) == text ? std::optional(out) : std::nullopt;
}

/// Letters of words outside quotes; none in a path.
size_t num_letters_of_words(const std::string& text) {
  size_t count = 0, of_word = 0;
  char quote = 0;
  size_t begin = text.starts_with('/') ? text.find(": ") : 0;
  for (; begin < text.size(); ++begin) {
    const char c = text[begin];
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (quote || c == '"' || c == '\'') quote = c == quote ? 0 : quote ? quote : c;
    of_word = is_letter && !quote ? of_word + 1 : 0;
    if (of_word == 2) count += 2;  // one letter may be that of a number
    if (of_word > 2) ++count;
  }
  return count;
}

struct Reading {
  Sentence sentence;
  size_t num_left = 0;  // letters that no pattern has
};

Reading read(const std::string& text, int depth);

Reading reading_of(const Pattern& pattern, const std::vector<std::string>& parts, int depth) {
  Reading out{{pattern.text, {}, {}, false}, 0};
  out.sentence.parts.reserve(parts.size());
  for (size_t i = 0; i < parts.size(); ++i) {
    if (is_in_quotes(pattern, i)) {
      out.sentence.parts.push_back({parts[i], {}, {}, true});
      continue;
    }
    if (auto number = length(parts[i], pattern.between[i + 1])) {
      out.sentence.parts.push_back(std::move(*number));
      continue;
    }
    Reading part = read(parts[i], depth + 1);
    out.num_left += part.num_left;
    out.sentence.parts.push_back(std::move(part.sentence));
  }
  return out;
}

/// By the pattern that leaves the least, the longest of those.
Reading read(const std::string& text, int depth) {
  Reading best{{text, {}, {}, true}, num_letters_of_words(text)};
  if (depth == kMaxDepth) return best;
  for (const Pattern& pattern : all_patterns()) {
    if (pattern.text == text) return {{text, {}, {}, false}, 0};
    const std::vector<std::string> parts = parts_of(text, pattern);
    if (parts.empty()) continue;
    Reading found = reading_of(pattern, parts, depth);
    if (best.sentence.is_verbatim ? found.num_left <= best.num_left
                                  : found.num_left < best.num_left)
      best = std::move(found);
    if (best.num_left == 0 && !best.sentence.is_verbatim) break;
  }
  return best;
}

}  // namespace

Sentence read_sentence(const std::string& english) { return read(english, 0).sentence; }

}  // namespace trivet::edit
