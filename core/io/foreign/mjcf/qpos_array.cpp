#include "core/io/foreign/mjcf/qpos_array.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <regex>

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/text/file_bytes.h"

namespace trivet {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr size_t kMostBytes = size_t{64} << 20;
constexpr size_t kPrefix = 10;      // magic, version, length of the header
constexpr size_t kHeaderStep = 64;  // the data begin at a multiple of it
const std::string kMagic("\x93NUMPY", 6);

template <class T>
std::vector<double> numbers_at(const std::string& bytes, size_t begin, size_t count) {
  std::vector<double> out;
  out.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, bytes.data() + begin + i * sizeof value, sizeof value);
    out.push_back(static_cast<double>(value));
  }
  return out;
}

// Where the data begin; 0: it is no array of version 1 to 3.
size_t data_begin(const std::string& bytes) {
  if (bytes.size() < kPrefix + 2 || bytes.compare(0, kMagic.size(), kMagic) != 0) return 0;
  const auto byte = [&](size_t i) {
    return static_cast<size_t>(static_cast<unsigned char>(bytes[i]));
  };
  const bool is_long = byte(6) > 1;
  const size_t length = byte(8) | byte(9) << 8 | (is_long ? byte(10) << 16 | byte(11) << 24 : 0);
  const size_t begin = (is_long ? kPrefix + 2 : kPrefix) + length;
  return begin <= bytes.size() ? begin : 0;
}

std::string entry(const std::string& header, const char* expression) {
  std::smatch found;
  return std::regex_search(header, found, std::regex(expression)) ? found[1].str() : "";
}

}  // namespace

bool is_qpos_array(const std::string& path) { return lower_extension(path) == ".npy"; }

std::vector<double> read_qpos_array(const std::string& path, size_t count) {
  std::error_code error;
  const std::optional<std::string> bytes =
      std::filesystem::is_regular_file(path, error) ? file_bytes(path, kMostBytes) : std::nullopt;
  if (!bytes) bad_file(path, "cannot be read; accepted: a file of at most %1 bytes", kMostBytes);
  const size_t begin = data_begin(*bytes);
  if (begin == 0) bad_file(path, "is no array of NumPy (.npy)");
  const std::string header = bytes->substr(0, begin);
  const std::string type = entry(header, "'descr': *'([^']*)'");
  const std::string shape = entry(header, "'shape': *\\(([0-9, ]*)\\)");
  const std::string n = std::to_string(count);
  const bool one_row = std::regex_match(shape, std::regex("(1, *)?" + n + " *,?"));
  const size_t size = type == "<f8" ? 8 : type == "<f4" ? 4 : 0;
  if (size == 0 || !one_row || bytes->size() - begin != count * size)
    bad_file(path,
             "has the type \"%1\" and the shape (%2); accepted: %3 numbers of the joints (qpos) in "
             "one row, float64 or float32",
             type, shape, count);
  std::vector<double> out = size == 8 ? numbers_at<double>(*bytes, begin, count)
                                      : numbers_at<float>(*bytes, begin, count);
  for (size_t i = 0; i < out.size(); ++i)
    if (!std::isfinite(out[i])) bad_file(path, "number %1 is not finite", i);
  return out;
}

std::string qpos_array(const std::vector<double>& numbers) {
  std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                     std::to_string(numbers.size()) + ",), }";
  const size_t whole = (kPrefix + text.size() + 1 + kHeaderStep - 1) / kHeaderStep * kHeaderStep;
  text.append(whole - kPrefix - text.size() - 1, ' ');
  text += '\n';
  std::string out = kMagic + std::string("\x01\x00", 2);
  out += static_cast<char>(text.size() & 0xFF);
  out += static_cast<char>(text.size() >> 8);
  out += text;
  out.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  return out;
}

}  // namespace trivet
