#include "core/base/sentence.h"

#include <iterator>
#include <sstream>

namespace trivet {

Sentence composed(const char* pattern, std::span<Sentence> parts) {
  Sentence out(pattern);
  out.parts.assign(std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
  return out;
}

Sentence figure(double value, int digits) {
  Sentence out;
  out.number = value;
  out.digits = digits;
  return out;
}

Sentence listed(std::vector<Sentence> sentences) {
  Sentence out;
  for (Sentence& each : sentences)
    out = out.empty() ? std::move(each) : say("%1; %2", std::move(out), std::move(each));
  return out;
}

std::string filled(const std::string& pattern, const std::vector<std::string>& parts) {
  std::string out;
  for (size_t i = 0; i < pattern.size(); ++i) {
    const bool is_place = pattern[i] == '%' && i + 1 < pattern.size();
    const size_t part = is_place ? static_cast<size_t>(pattern[i + 1] - '1') : parts.size();
    if (part < parts.size())
      out += parts[part], ++i;
    else
      out += pattern[i];
  }
  return out;
}

std::string in_english(const Sentence& sentence) {
  if (sentence.is_verbatim) return sentence.text;
  if (sentence.number) {
    std::ostringstream out;
    out.precision(sentence.digits);
    out << *sentence.number;
    return out.str();
  }
  return filled(sentence.text, in_english(sentence.parts));
}

std::vector<std::string> in_english(const std::vector<Sentence>& sentences) {
  std::vector<std::string> out;
  out.reserve(sentences.size());
  for (const Sentence& each : sentences) out.push_back(in_english(each));
  return out;
}

}  // namespace trivet
