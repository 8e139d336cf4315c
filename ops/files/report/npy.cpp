#include "ops/files/report/npy.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/base/printable.h"

namespace trivet {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr size_t kHeaderStep = 64;  // the data begin at a multiple of it
constexpr char32_t kReplacement = 0xFFFD;

/// Code points; bytes that are no UTF-8 become replacement characters.
std::u32string code_points(const std::string& text) {
  std::u32string out;
  for (size_t i = 0; i < text.size();) {
    const size_t length = utf8_length(text, i);
    const auto first = static_cast<unsigned char>(text[i]);
    char32_t point = length == 0 ? kReplacement : length == 1 ? first : first & (0x7F >> length);
    for (size_t k = 1; k < length; ++k)
      point = point << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
    out += point;
    i += std::max<size_t>(length, 1);
  }
  return out;
}

template <class T>
void append_raw(std::string& out, const T& value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

class NpyField {
 public:
  NpyField(const std::string& key, const std::vector<OrderedJson>& rows) : m_key(key) {
    // The first row tells the type: columns have one.
    const bool any = !rows.empty();
    m_is_flag = any && rows[0].at(key).is_boolean();
    m_is_text = any && rows[0].at(key).is_string();
    for (const OrderedJson& row : rows)
      if (m_is_text)
        m_width = std::max(m_width, code_points(row.at(key).get_ref<const std::string&>()).size());
  }

  std::string description() const {
    const std::string type = m_is_flag ? "|b1" : m_is_text ? "<U" + std::to_string(m_width) : "<f8";
    return "('" + m_key + "', '" + type + "')";
  }

  void append(std::string& out, const OrderedJson& row) const {
    const OrderedJson& value = row.at(m_key);
    if (m_is_flag) return append_raw(out, static_cast<std::uint8_t>(value.get<bool>()));
    if (!m_is_text)
      return append_raw(
          out, value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
    std::u32string text = code_points(value.get_ref<const std::string&>());
    text.resize(m_width);
    for (const char32_t point : text) append_raw(out, point);
  }

 private:
  const std::string m_key;
  bool m_is_flag = false, m_is_text = false;
  size_t m_width = 1;  // characters
};

std::string npy_header(const std::vector<NpyField>& fields, size_t num_rows) {
  std::string text = "{'descr': [";
  for (const NpyField& field : fields) text += field.description() + ", ";
  text += "], 'fortran_order': False, 'shape': (" + std::to_string(num_rows) + ",), }";
  std::string out("\x93NUMPY\x01\x00", 8);
  const size_t before = out.size() + 2;  // the length of the text has two bytes
  const size_t whole = (before + text.size() + 1 + kHeaderStep - 1) / kHeaderStep * kHeaderStep;
  text.append(whole - before - text.size() - 1, ' ');
  text += '\n';
  append_raw(out, static_cast<std::uint16_t>(text.size()));
  return out += text;
}

}  // namespace

std::string npy_records(const std::vector<std::string>& keys,
                        const std::vector<OrderedJson>& rows) {
  std::vector<NpyField> fields;
  fields.reserve(keys.size());
  for (const std::string& key : keys) fields.emplace_back(key, rows);
  std::string out = npy_header(fields, rows.size());
  for (const OrderedJson& row : rows)
    for (const NpyField& field : fields) field.append(out, row);
  return out;
}

}  // namespace trivet
