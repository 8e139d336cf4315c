#include "core/io/gltf/glb_container.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

void append_chunk(std::string& out, std::uint32_t type, const std::string& data, char padding) {
  const size_t padded = (data.size() + 3) / 4 * 4;
  append_bytes(out, static_cast<std::uint32_t>(padded));
  append_bytes(out, type);
  out += data;
  out.append(padded - data.size(), padding);
}

struct Header {
  std::uint32_t magic = 0, version = 0, total_bytes = 0, json_bytes = 0, json_type = 0;
};
static_assert(sizeof(Header) == kHeaderBytes + kChunkHeaderBytes);

void check_header(const std::string& path, const Header& header, std::uintmax_t file_bytes) {
  if (header.magic != kGlbMagic)
    bad_file(path, "is not binary glTF: it does not begin with 'glTF'");
  if (header.version != 2) bad_file(path, "glTF version %1; accepted: 2", header.version);
  if (header.total_bytes > file_bytes)
    bad_file(path, "is truncated: %1 bytes of %2", file_bytes, header.total_bytes);
  if (header.json_type != kJsonChunk) bad_file(path, "the first glTF chunk is not JSON");
  if (sizeof(Header) + std::uint64_t{header.json_bytes} > header.total_bytes)
    bad_file(path, "the glTF JSON chunk is longer than the file");
}

}  // namespace

std::string pack_glb(std::string json, const std::string& binary) {
  const std::uint64_t total =
      kHeaderBytes + kChunkHeaderBytes + (json.size() + 3) / 4 * 4 +
      (binary.empty() ? 0 : kChunkHeaderBytes + (binary.size() + 3) / 4 * 4);
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw Error(Error::Kind::BadInput,
                "the scene needs %1 bytes, more than the 4 GiB limit of binary glTF", total);
  std::string out;
  out.reserve(total);
  append_bytes(out, kGlbMagic);
  append_bytes(out, std::uint32_t{2});
  append_bytes(out, static_cast<std::uint32_t>(total));
  append_chunk(out, kJsonChunk, json, ' ');
  if (!binary.empty()) append_chunk(out, kBinaryChunk, binary, '\0');
  return out;
}

std::string read_glb_json(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) bad_file(path, "is a folder, not a scene file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) bad_file(path, "cannot be read: %1", std::strerror(errno));
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  if (error) bad_file(path, "cannot be read: %1", error.message().c_str());
  Header header;
  if (file_bytes < sizeof header || !in.read(reinterpret_cast<char*>(&header), sizeof header))
    bad_file(path, "is not binary glTF: only %1 bytes", file_bytes);
  check_header(path, header, file_bytes);
  std::string json(header.json_bytes, '\0');
  if (!in.read(json.data(), header.json_bytes)) bad_file(path, "cannot be read to its end");
  json.erase(json.find_last_not_of('\0') + 1);  // padding of some writers
  return json;
}

std::uint32_t glb_version(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::uint32_t words[2] = {0, 0};
  const bool read = bool(in.read(reinterpret_cast<char*>(words), sizeof words));
  return read && words[0] == kGlbMagic ? words[1] : 0;
}

// Chunks begin at multiples of 4, but some writers do not pad the JSON.
std::string read_glb_binary(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Header head;
  if (!file.read(reinterpret_cast<char*>(&head), sizeof head)) return "";
  const std::uint64_t end = sizeof head + std::uint64_t{head.json_bytes};
  for (const std::uint64_t at : {end, (end + 3) / 4 * 4}) {
    std::uint32_t header[2] = {0, 0};
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(reinterpret_cast<char*>(header), kChunkHeaderBytes) || header[1] != kBinaryChunk)
      continue;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::string bytes(error ? 0 : std::min<std::uintmax_t>(header[0], size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(file.gcount()));
    return bytes;
  }
  return "";
}

}  // namespace trivet
