#include "core/io/threemf/zip_archive.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>

#include "core/base/bad_input.h"
#include "core/base/printable.h"

namespace trivet {
namespace {

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

[[noreturn]] void fail_damaged(const std::string& path, archive* a) {
  const char* const reason = archive_error_string(a);
  bad_file(path, "is a damaged ZIP archive: %1", printable(reason ? reason : "unknown error"));
}

// @param stated  a size that is not trusted.
std::string content_of(const std::string& path, archive* a, std::uintmax_t max_bytes,
                       std::uintmax_t stated) {
  constexpr std::uintmax_t kMostAtOnce = std::uintmax_t{1} << 28, kPiece = std::uintmax_t{1} << 16;
  std::string out;
  out.reserve(std::min({stated, max_bytes, kMostAtOnce}) + kPiece);
  while (true) {
    const size_t before = out.size();
    out.resize(before + kPiece);
    const la_ssize_t count = archive_read_data(a, out.data() + before, out.size() - before);
    if (count < 0) fail_damaged(path, a);
    out.resize(before + static_cast<size_t>(count));
    if (count == 0) return out;
    if (out.size() > max_bytes) bad_file(path, "has more than %1 bytes unpacked", max_bytes);
  }
}

}  // namespace

std::map<std::string, std::string> zip_entries(
    const std::string& path, std::string_view bytes, std::uintmax_t max_bytes,
    const std::function<bool(const std::string&)>& wanted) {
  const Archive a(archive_read_new(), archive_read_free);
  archive_read_support_format_zip(a.get());
  if (archive_read_open_memory(a.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    fail_damaged(path, a.get());
  std::map<std::string, std::string> out;
  archive_entry* entry = nullptr;
  while (true) {
    const int status = archive_read_next_header(a.get(), &entry);
    if (status == ARCHIVE_EOF) return out;
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN) fail_damaged(path, a.get());
    const char* const stored = archive_entry_pathname_utf8(entry);
    std::string name = stored ? stored : "";
    while (name.starts_with('/')) name.erase(0, 1);
    if (!wanted(name)) continue;
    const la_int64_t stated = archive_entry_size_is_set(entry) ? archive_entry_size(entry) : 0;
    std::string content = content_of(path, a.get(), max_bytes,
                                     static_cast<std::uintmax_t>(std::max<la_int64_t>(stated, 0)));
    max_bytes -= content.size();
    out.try_emplace(std::move(name), std::move(content));
  }
}

}  // namespace trivet
