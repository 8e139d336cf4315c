#include "core/io/foreign/tag_text.h"

#include <charconv>
#include <optional>

#include "core/io/text/words.h"

namespace trivet {
namespace {

bool is_space(char c) { return is_blank(c) || is_line_end(c); }

// The shortest decimal that gives the double back.
std::string shortest(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr;
  return std::string(text, end);
}

/// Place of an attribute in a tag: from the blank before it to behind its closing quote.
struct AttributePlace {
  size_t begin, value, value_end, end;
};

// Scans names and quoted values, so that no text inside a value is taken for an attribute.
std::optional<AttributePlace> find_attribute(const std::string& tag, const std::string& name) {
  size_t i = 1;
  while (i < tag.size() && !is_space(tag[i]) && tag[i] != '>' && tag[i] != '/') ++i;
  while (i < tag.size()) {
    const size_t begin = i;
    while (i < tag.size() && is_space(tag[i])) ++i;
    const size_t key = i;
    while (i < tag.size() && !is_space(tag[i]) && tag[i] != '=' && tag[i] != '>' && tag[i] != '/')
      ++i;
    const std::string found = tag.substr(key, i - key);
    while (i < tag.size() && (is_space(tag[i]) || tag[i] == '=')) ++i;
    if (i >= tag.size() || (tag[i] != '"' && tag[i] != '\'')) return std::nullopt;
    const size_t close = tag.find(tag[i], i + 1);
    if (close == tag.npos) return std::nullopt;
    if (found == name) return AttributePlace{begin, i + 1, close, close + 1};
    i = close + 1;
  }
  return std::nullopt;
}

}  // namespace

std::vector<TextWord> text_words(const std::string& text) {
  std::vector<TextWord> out;
  for (size_t i = 0; i < text.size();) {
    if (is_space(text[i])) {
      ++i;
      continue;
    }
    const size_t begin = i;
    while (i < text.size() && !is_space(text[i])) ++i;
    out.push_back({begin, i});
  }
  return out;
}

double number_at(const std::string& text, const TextWord& word) {
  return number_from(text.substr(word.begin, word.end - word.begin)).value_or(0);
}

size_t end_of_tag(const std::string& bytes, size_t begin) {
  char quote = 0;
  for (size_t i = begin; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  return bytes.size();
}

std::string attribute_of(const std::string& tag, const std::string& name) {
  const auto at = find_attribute(tag, name);
  return at ? tag.substr(at->value, at->value_end - at->value) : "";
}

std::string with_numbers(const std::string& old, const std::vector<double>& numbers) {
  const std::vector<TextWord> words = text_words(old);
  std::string out = old;
  // Another count of numbers is written anew, else only those words that changed.
  if (words.size() != numbers.size()) {
    out.clear();
    for (size_t i = 0; i < numbers.size(); ++i) out += (i ? " " : "") + shortest(numbers[i]);
    return out;
  }
  for (size_t i = words.size(); i-- > 0;) {
    const std::string word = old.substr(words[i].begin, words[i].end - words[i].begin);
    if (number_from(word) != numbers[i])
      out.replace(words[i].begin, word.size(), shortest(numbers[i]));
  }
  return out;
}

std::string with_attributes(std::string tag,
                            const std::vector<std::pair<std::string, std::string>>& changes) {
  for (const auto& [name, value] : changes) {
    const auto at = find_attribute(tag, name);
    // An empty value takes the attribute away.
    if (at && value.empty()) {
      tag.erase(at->begin, at->end - at->begin);
    } else if (at) {
      tag.replace(at->value, at->value_end - at->value, value);
    } else if (!value.empty()) {
      size_t end = tag.size() - (tag.ends_with("/>") ? 2 : 1);
      while (end > 0 && is_space(tag[end - 1])) --end;
      std::string attribute = " ";
      attribute.append(name).append("=\"").append(value).append("\"");
      tag.insert(end, attribute);
    }
  }
  return tag;
}

}  // namespace trivet
