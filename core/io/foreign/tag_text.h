// Numbers and attributes changed in the text of a start tag: all other bytes stay.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trivet {

/// Words of a text and where they stand: from `begin` to before `end`.
struct TextWord {
  size_t begin, end;
};
std::vector<TextWord> text_words(const std::string& text);

/// The number that a word is; 0: it is none.
double number_at(const std::string& text, const TextWord& word);

/// Text of numbers in place of others: those that are equal keep their text, and so does the white
/// space. @param old  empty, or with another count: all numbers, a blank between.
std::string with_numbers(const std::string& old, const std::vector<double>& numbers);

/// One past the '>' of the tag that begins there; quotes may hold others.
size_t end_of_tag(const std::string& bytes, size_t begin);

/// An attribute's value as it is written; empty: the tag has none of that name.
std::string attribute_of(const std::string& tag, const std::string& name);

/// One start tag with changed attributes. An empty value takes the attribute away.
std::string with_attributes(std::string tag,
                            const std::vector<std::pair<std::string, std::string>>& changes);

}  // namespace trivet
