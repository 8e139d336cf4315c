#include "core/io/assimp/files.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/base/extension.h"
#include "core/io/opened_files.h"

namespace trivet {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_obj(const std::string& file) { return lower_extension(file) == ".obj"; }

// An OBJ file byte by byte, with its lines as assimp has them: behind a backslash they go on in the
// next one.
class ObjLines {
 public:
  // True at the first digit of a coordinate that begins with its point, as in "v .5 0 0".
  bool reads_bare_number(char c) {
    const bool found = m_after_point && is_digit(c);
    m_after_point = false;
    if (c == '\\') {
      m_goes_on = true;
    } else if (c == '\n' || c == '\r') {
      if (!m_goes_on) m_before = '\n';
      m_goes_on = m_goes_on && c == '\r';
    } else {
      if (m_before == '\n') m_coordinates = c == 'v';
      m_after_point = m_coordinates && c == '.' && (m_before == ' ' || m_before == '\t');
      m_before = c;
    }
    return found;
  }

 private:
  char m_before = '\n';  // in its line
  bool m_coordinates = false, m_goes_on = false, m_after_point = false;
};

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// A zero before the points of coordinates; names stay what they are.
std::string with_zeros_before_points(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  ObjLines lines;
  for (const char c : text) {
    if (lines.reads_bare_number(c)) out.insert(out.end() - 1, '0');
    out += c;
  }
  return out;
}

// True if a point follows a blank, or what ends or continues a line. Most files have none.
bool may_begin_with_point(std::string_view text, char before) {
  constexpr std::string_view kNotInNumber = " \t\\\n\r";
  for (size_t at = text.find('.'); at != std::string_view::npos; at = text.find('.', at + 1))
    if (kNotInNumber.find(at > 0 ? text[at - 1] : before) != std::string_view::npos) return true;
  return false;
}

// Calls f(piece) with the bytes of a file until that is true. @return whether it was.
template <class F>
bool in_any_piece(const std::string& file, F f) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 1 << 16> piece;
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0)
    if (f(std::string_view(piece.data(), static_cast<size_t>(in.gcount())))) return true;
  return false;
}

bool must_be_mended(const std::string& file) {
  bool marked = false, first = true;
  char before = '\n';
  const bool doubtful = in_any_piece(file, [&](std::string_view text) {
    marked = first && text.starts_with(kByteOrderMark);
    const bool found = marked || may_begin_with_point(text, before);
    first = false;
    before = text.back();
    return found;
  });
  if (!doubtful || marked) return doubtful;
  ObjLines lines;
  return in_any_piece(file, [&](std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [&](char c) { return lines.reads_bare_number(c); });
  });
}

// assimp 5.2 leaves out vertices with ".5", so that faces get others; "0.5" and "-.5" it reads. The
// line behind a byte order mark it leaves out, too.
std::string mended_obj(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string_view whole = text;
  return with_zeros_before_points(
      whole.starts_with(kByteOrderMark) ? whole.substr(kByteOrderMark.size()) : whole);
}

Assimp::IOStream* stream_of(const std::string& text) {
  auto* const bytes = new std::uint8_t[text.size()];
  std::copy(text.begin(), text.end(), bytes);
  return new Assimp::MemoryIOStream(bytes, text.size(), true);
}

}  // namespace

bool FolderIoSystem::may_open(const std::string& file) const {
  constexpr size_t kMaxNames = 100;
  if (file == m_model || m_folder.has(file)) return true;
  const bool known = std::find(m_outside.begin(), m_outside.end(), file) != m_outside.end();
  if (!known && m_outside.size() < kMaxNames && !m_folder.holds(file)) m_outside.push_back(file);
  return false;
}

bool FolderIoSystem::Exists(const char* file) const {
  return may_open(file) && DefaultIOSystem::Exists(file);
}

Assimp::IOStream* FolderIoSystem::Open(const char* file, const char* mode) {
  const bool reads = std::string(mode).find_first_of("wa+") == std::string::npos;
  if (!reads || !may_open(file)) return nullptr;
  note_opened(m_model, {file});
  if (is_obj(file) && must_be_mended(file)) return stream_of(mended_obj(file));
  return DefaultIOSystem::Open(file, mode);
}

}  // namespace trivet
