#include "core/io/assimp/assimp_files.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/extension.h"

namespace trivet {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_obj(const std::string& file) { return lower_extension(file) == ".obj"; }

// A number that begins with its point, as in "v .5 0 0", after `before` and with `after` behind it.
bool is_bare_point(char before, char c, char after) {
  return c == '.' && (before == ' ' || before == '\t') && is_digit(after);
}

bool has_bare_points(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 1 << 16> piece;
  char last[2] = {'\n', '\n'};
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0)
    for (std::streamsize i = 0; i < in.gcount(); ++i) {
      const char c = piece[static_cast<size_t>(i)];
      if (is_bare_point(last[0], last[1], c)) return true;
      last[0] = last[1], last[1] = c;
    }
  return false;
}

// Of lines with coordinates; names stay what they are.
std::string with_zeros_before_points(const std::string& text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  bool coordinates = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : '\n';
    if (before == '\n' || before == '\r') coordinates = text[i] == 'v';
    if (coordinates && i + 1 < text.size() && is_bare_point(before, text[i], text[i + 1]))
      out += '0';
    out += text[i];
  }
  return out;
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
  // assimp 5.2 leaves out vertices with ".5", so that faces get others; "0.5" and "-.5" it reads.
  if (is_obj(file) && has_bare_points(file)) {
    std::ifstream in(file, std::ios::binary);
    return stream_of(with_zeros_before_points({std::istreambuf_iterator<char>(in), {}}));
  }
  return DefaultIOSystem::Open(file, mode);
}

}  // namespace trivet
