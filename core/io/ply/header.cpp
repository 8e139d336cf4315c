#include "core/io/ply/header.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

struct NamedType {
  std::string_view name;
  PlyType type;
};

constexpr NamedType kTypes[] = {
    {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
    {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64}};

class HeaderReader {
 public:
  HeaderReader(const std::string& path, std::string_view bytes) : m_path(path), m_bytes(bytes) {}

  PlyHeader read() {
    if (!equal_words(trimmed(next_line()), "ply"))
      bad_file(m_path, "cannot be read as a model: it does not begin with \"ply\"");
    m_ends_in_return = ended_in_return();
    for (std::string_view line = trimmed(next_line()); !equal_words(line, "end_header");
         line = trimmed(next_line()))
      read_line(line);
    m_out.size = m_at;
    return std::move(m_out);
  }

 private:
  [[noreturn]] void fail(const Sentence& reason) const {
    bad_file(m_path, "line %1: %2", m_line, reason);
  }

  bool ended_in_return() const { return m_bytes[m_at - 1] == '\r'; }

  // Data may begin with a byte that looks like the end of a line: no more than one is taken.
  std::string_view next_line() {
    size_t end = m_at;
    while (end < m_bytes.size() && !is_line_end(m_bytes[end])) ++end;
    if (end == m_bytes.size())
      bad_file(m_path, "cannot be read as a model: the PLY header has no end_header");
    const std::string_view line = m_bytes.substr(m_at, end - m_at);
    const bool two = m_bytes[end] == '\r' && end + 1 < m_bytes.size() && m_bytes[end + 1] == '\n';
    m_at = end + (two && !m_ends_in_return ? 2 : 1);
    ++m_line;
    return line;
  }

  void read_line(std::string_view line) {
    const std::string_view key = next_word(line);
    if (equal_words(key, "format")) {
      read_format(next_word(line));
    } else if (equal_words(key, "element")) {
      read_element(line);
    } else if (equal_words(key, "property")) {
      read_property(line);
    } else if (equal_words(key, "comment") && equal_words(next_word(line), "texturefile")) {
      m_out.textures.emplace_back(trimmed(line));
    }
  }

  void read_format(std::string_view name) {
    if (equal_words(name, "ascii"))
      m_out.format = PlyFormat::Text;
    else if (equal_words(name, "binary_little_endian"))
      m_out.format = PlyFormat::LittleEndian;
    else if (equal_words(name, "binary_big_endian"))
      m_out.format = PlyFormat::BigEndian;
    else
      fail(say("the format \"%1\"; accepted: ascii, binary_little_endian, binary_big_endian",
               printable(name, 40)));
  }

  void read_element(std::string_view line) {
    PlyElement element;
    element.name = lower_case(next_word(line));
    const auto count = integer_from(next_word(line));
    if (!count || *count < 0) fail("an element without its number");
    element.count = *count;
    // Each takes at least a byte.
    if (static_cast<std::uint64_t>(*count) > m_bytes.size())
      bad_file(m_path, "is truncated: a file of %1 bytes cannot hold %2 elements \"%3\"",
               m_bytes.size(), *count, printable(element.name, 40));
    m_out.elements.push_back(std::move(element));
  }

  void read_property(std::string_view line) {
    if (m_out.elements.empty()) fail("a property before the first element");
    PlyProperty property;
    std::string_view word = next_word(line);
    if (equal_words(word, "list")) {
      property.count_type = type_of(next_word(line));
      word = next_word(line);
    }
    property.type = type_of(word);
    property.name = lower_case(next_word(line));
    m_out.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_of(std::string_view name) const {
    for (const NamedType& t : kTypes)
      if (equal_words(name, t.name)) return t.type;
    fail(say("the type \"%1\"; accepted: char, uchar, short, ushort, int, uint, float, double",
             printable(name, 40)));
  }

  const std::string m_path;
  std::string_view m_bytes;
  size_t m_at = 0;
  std::int64_t m_line = 0;
  bool m_ends_in_return = false;  // alone
  PlyHeader m_out;
};

}  // namespace

size_t size_of(PlyType type) {
  constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<size_t>(type)];
}

double full_scale(PlyType type) {
  constexpr double kScales[] = {127, 255, 32767, 65535, 2147483647, 4294967295, 1, 1};
  return kScales[static_cast<size_t>(type)];
}

std::int64_t PlyHeader::num_items() const {
  std::int64_t count = 0;
  for (const PlyElement& element : elements) count += element.count;
  return count;
}

PlyHeader read_ply_header(const std::string& path, std::string_view bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace trivet
