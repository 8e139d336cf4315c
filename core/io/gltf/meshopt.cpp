#include <meshoptimizer.h>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/gltf/compressed.h"
#include "core/io/gltf/meshopt_attributes.h"

namespace trivet::gltf {
namespace {

// The most that decoders get out of a byte; more is only claimed.
constexpr size_t kMostPerByte = 1024;
constexpr size_t kMostStride = 256;

std::string text_or(const GltfJson& value, const char* otherwise) {
  return value.is_string() ? value.get<std::string>() : otherwise;
}

[[noreturn]] void fail(const Sentence& what) { bad_input("a compressed buffer view %1", what); }

struct Stream {
  size_t count = 0, stride = 0;
  std::string mode, filter;
};

// Checks the preconditions of the library.
void check(const Stream& s, size_t num_bytes) {
  const auto refuse = [&](bool wrong) {
    if (wrong)
      fail(say("of mode %1 and filter %2 has %3 items of %4 bytes", printable(s.mode, 40),
               printable(s.filter, 40), s.count, s.stride));
  };
  const bool indices = s.mode == "TRIANGLES" || s.mode == "INDICES";
  if (!indices && s.mode != "ATTRIBUTES") fail(say("has the mode %1", printable(s.mode, 40)));
  refuse(indices && s.stride != 2 && s.stride != 4);
  refuse(s.mode == "TRIANGLES" && s.count % 3 != 0);
  refuse(!indices && (s.stride == 0 || s.stride > kMostStride || s.stride % 4 != 0));
  refuse(s.filter == "OCTAHEDRAL" && s.stride != 4 && s.stride != 8);
  refuse(s.filter == "QUATERNION" && s.stride != 8);
  refuse(s.filter == "COLOR" && s.stride != 4 && s.stride != 8);
  refuse(indices && s.filter != "NONE");
  if (s.count > (num_bytes + 64) * kMostPerByte / s.stride)
    fail(say("of %1 bytes claims to hold %2 items of %3", num_bytes, s.count, s.stride));
}

void apply_filter(const Stream& s, std::string& out) {
  if (s.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(out.data(), s.count, s.stride);
  else if (s.filter == "QUATERNION")
    meshopt_decodeFilterQuat(out.data(), s.count, s.stride);
  else if (s.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(out.data(), s.count, s.stride);
  else if (s.filter == "COLOR")
    apply_colour_filter(out, s.stride);
  else if (s.filter != "NONE")
    fail(say("has the filter %1; accepted: NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL and COLOR",
             printable(s.filter, 40)));
}

// By the library, but for what is later than it.
std::string decoded(const Stream& s, std::string_view bytes) {
  const bool attributes = s.mode == "ATTRIBUTES";
  if (attributes && bytes.starts_with(kAttributes1))
    return decoded_attributes(bytes, s.count, s.stride);
  std::string out(s.count * s.stride, '\0');
  const auto* const from = reinterpret_cast<const unsigned char*>(bytes.data());
  using Decode = int (*)(void*, size_t, size_t, const unsigned char*, size_t);
  const Decode decode = attributes              ? Decode(meshopt_decodeVertexBuffer)
                        : s.mode == "TRIANGLES" ? Decode(meshopt_decodeIndexBuffer)
                                                : Decode(meshopt_decodeIndexSequence);
  return decode(out.data(), s.count, s.stride, from, bytes.size()) == 0 ? out : std::string();
}

}  // namespace

std::string decoded_meshopt(std::string_view bytes, const GltfJson& compression) {
  const Stream s{
      index_from(member(compression, "count")), index_from(member(compression, "byteStride")),
      text_or(member(compression, "mode"), "none"), text_or(member(compression, "filter"), "NONE")};
  check(s, bytes.size());
  std::string out = decoded(s, bytes);
  if (out.empty() && s.count > 0) fail("is damaged");
  apply_filter(s, out);
  return out;
}

}  // namespace trivet::gltf
