#include "core/io/foreign/numbers.h"

#include <algorithm>
#include <cmath>

#include "core/base/bad_input.h"
#include "core/base/limits.h"
#include "core/io/text/words.h"

namespace trivet {

std::string XmlPlace::text() const {
  const std::string name = node.file < files.size() ? files[node.file].path : "";
  return name + ", line " + std::to_string(node.line) + ", <" + node.tag + ">";
}

void XmlPlace::refuse(const std::string& attribute, const std::string& value,
                      const Sentence& accepted) const {
  bad_input("%1: %2=\"%3\"; accepted: %4", text(), attribute, value, accepted);
}

std::vector<double> numbers_in(const std::string& text, const std::string& attribute,
                               const XmlPlace& place) {
  std::vector<double> out;
  std::string line = text;
  std::replace_if(line.begin(), line.end(), is_line_end, ' ');
  std::string_view rest = line;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    const auto number = number_from(word);
    if (!number || !(std::abs(*number) <= kMaxLength)) place.refuse(attribute, text, "numbers");
    out.push_back(*number);
  }
  return out;
}

std::vector<double> numbers_in(const std::string& text, const std::string& attribute,
                               const XmlPlace& place, size_t least, size_t most) {
  std::vector<double> out = numbers_in(text, attribute, place);
  if (out.size() < least || out.size() > most)
    place.refuse(attribute, text,
                 least == most ? say("%1 numbers", least) : say("%1 to %2 numbers", least, most));
  return out;
}

}  // namespace trivet
