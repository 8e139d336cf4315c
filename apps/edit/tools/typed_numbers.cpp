#include "apps/edit/tools/typed_numbers.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace trivet::edit {
namespace {

constexpr size_t kLongest = 12;  // characters of a number

double value_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::string plain_number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

TypedNumbers::TypedNumbers(std::vector<std::string> axes, size_t first, std::string unit)
    : m_axes(std::move(axes)),
      m_texts(m_axes.size()),
      m_current(std::min(first, m_axes.size() - 1)),
      m_unit(std::move(unit)) {}

bool TypedNumbers::is_part(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '-';
}

void TypedNumbers::type(char c) {
  if (!takes_numbers() || !is_part(c)) return;
  std::string& text = m_texts[m_current];
  if (c == '-') {
    if (text.starts_with('-'))
      text.erase(0, 1);
    else
      text.insert(0, 1, '-');
    return;
  }
  if (c == ',') c = '.';
  if (text.size() >= kLongest || (c == '.' && text.find('.') != std::string::npos)) return;
  if (c == '.' && (text.empty() || text == "-")) text += '0';
  text += c;
}

void TypedNumbers::erase() {
  if (takes_numbers() && !m_texts[m_current].empty()) m_texts[m_current].pop_back();
}

void TypedNumbers::next_axis() {
  if (takes_numbers()) m_current = (m_current + 1) % m_axes.size();
}

bool TypedNumbers::empty() const {
  return std::all_of(m_texts.begin(), m_texts.end(),
                     [](const std::string& text) { return text.empty(); });
}

std::vector<double> TypedNumbers::values() const {
  std::vector<double> out;
  out.reserve(m_texts.size());
  for (const std::string& text : m_texts) out.push_back(value_of(text));
  return out;
}

std::string TypedNumbers::text() const {
  std::string out;
  for (size_t i = 0; i < m_axes.size(); ++i) {
    const bool is_typed = i == m_current;
    if (i > 0) out.append("  ");
    if (!m_axes[i].empty())
      out.append(is_typed ? "[" : "").append(m_axes[i]).append(is_typed ? "] " : " ");
    out.append(m_texts[i].empty() ? "0" : m_texts[i]).append(m_unit);
  }
  return out;
}

}  // namespace trivet::edit
