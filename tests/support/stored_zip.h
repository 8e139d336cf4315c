// ZIP archives of stored entries, with right checksums.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace trivet::testing {

class StoredZip {
 public:
  /// @param extra  fields of each entry's header.
  void add(const std::string& name, const std::string& content, const std::string& extra = "") {
    const auto offset = static_cast<std::uint32_t>(m_out.size());
    m_out += "PK\3\4" + fields(name, content, extra) + name + extra + content;
    m_directory += "PK\1\2" + std::string("\24\0", 2) + fields(name, content, "");
    m_directory.append(10, '\0');  // comment, disk, attributes
    append(m_directory, offset);
    m_directory += name;
    ++m_count;
  }

  std::string bytes() const {
    std::string out = m_out + m_directory + "PK\5\6" + std::string(4, '\0');
    for (int i = 0; i < 2; ++i) append(out, m_count);
    append(out, static_cast<std::uint32_t>(m_directory.size()));
    append(out, static_cast<std::uint32_t>(m_out.size()));
    return out + std::string(2, '\0');
  }

 private:
  template <class T>
  static void append(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
  }

  static std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char c : bytes) {
      crc ^= static_cast<unsigned char>(c);
      for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
  }

  // Fields that the entry of a file and that of the directory have in common.
  static std::string fields(const std::string& name, const std::string& content,
                            const std::string& extra) {
    std::string out;
    for (const int v : {20, 0x800, 0, 0, 0x21}) append(out, static_cast<std::uint16_t>(v));
    append(out, crc32(content));
    for (int i = 0; i < 2; ++i) append(out, static_cast<std::uint32_t>(content.size()));
    append(out, static_cast<std::uint16_t>(name.size()));
    append(out, static_cast<std::uint16_t>(extra.size()));
    return out;
  }

  std::string m_out, m_directory;
  std::uint16_t m_count = 0;
};

}  // namespace trivet::testing
