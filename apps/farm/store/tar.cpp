#include "apps/farm/store/tar.h"

#include <archive.h>
#include <archive_entry.h>

#include <exception>
#include <new>
#include <utility>

#include "core/base/bad_input.h"

namespace trivet::farm {

struct TarWriter::State {
  TarSink sink;
  std::exception_ptr error;  // of the sink, which C code called
  std::unique_ptr<archive, decltype(&archive_write_free)> tar{archive_write_new(),
                                                              archive_write_free};
};

namespace {

struct EntryDelete {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

la_ssize_t pass_on(archive*, void* data, const void* bytes, size_t size) {
  auto* const state = static_cast<TarWriter::State*>(data);
  try {
    state->sink({static_cast<const char*>(bytes), size});
    return static_cast<la_ssize_t>(size);
  } catch (...) {
    state->error = std::current_exception();
    return -1;
  }
}

}  // namespace

TarWriter::TarWriter(TarSink sink) : m_state(std::make_unique<State>()) {
  archive* const tar = m_state->tar.get();
  if (!tar) throw std::bad_alloc();
  m_state->sink = std::move(sink);
  archive_write_set_format_ustar(tar);
  archive_write_set_bytes_per_block(tar, 10240);
  archive_write_set_bytes_in_last_block(tar, 1);
  archive_write_open(tar, m_state.get(), nullptr, pass_on, nullptr);
}

TarWriter::~TarWriter() {
  // An unfinished one shall not write its end: the sink may be gone.
  m_state->sink = [](std::string_view) {};
}

namespace {

void check_written(TarWriter::State& state, bool ok) {
  if (state.error) std::rethrow_exception(std::exchange(state.error, nullptr));
  if (!ok)
    throw Error(Error::Kind::Environment, "a tar cannot be written: %1",
                archive_error_string(state.tar.get()));
}

}  // namespace

void TarWriter::add(const std::string& name, std::string_view bytes) {
  const std::unique_ptr<archive_entry, EntryDelete> entry(archive_entry_new());
  if (!entry) throw std::bad_alloc();
  archive_entry_set_pathname(entry.get(), name.c_str());
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_mtime(entry.get(), 0, 0);
  archive* const tar = m_state->tar.get();
  check_written(*m_state, archive_write_header(tar, entry.get()) == ARCHIVE_OK);
  const la_ssize_t written = archive_write_data(tar, bytes.data(), bytes.size());
  check_written(*m_state, written == static_cast<la_ssize_t>(bytes.size()));
  check_written(*m_state, archive_write_finish_entry(tar) == ARCHIVE_OK);
}

void TarWriter::finish() {
  check_written(*m_state, archive_write_close(m_state->tar.get()) == ARCHIVE_OK);
}

struct TarReader::State {
  std::unique_ptr<archive, decltype(&archive_read_free)> tar{archive_read_new(), archive_read_free};
};

TarReader::TarReader(std::string path)
    : m_path(std::move(path)), m_state(std::make_unique<State>()) {
  archive* const tar = m_state->tar.get();
  if (!tar) throw std::bad_alloc();
  archive_read_support_format_tar(tar);
  if (archive_read_open_filename(tar, m_path.c_str(), 1 << 16) != ARCHIVE_OK) fail();
}

TarReader::~TarReader() = default;

void TarReader::fail() const {
  const char* const why = archive_error_string(m_state->tar.get());
  bad_file(m_path, "is damaged, or no tar: %1", (why ? why : "unknown"));
}

std::optional<std::string> TarReader::next() {
  archive_entry* entry = nullptr;
  const int result = archive_read_next_header(m_state->tar.get(), &entry);
  if (result == ARCHIVE_EOF) return std::nullopt;
  if (result != ARCHIVE_OK) fail();
  const char* const name = archive_entry_pathname(entry);
  return name ? name : "";
}

std::string TarReader::bytes() {
  std::string out;
  char block[1 << 16];
  for (la_ssize_t count;
       (count = archive_read_data(m_state->tar.get(), block, sizeof block)) != 0;) {
    if (count < 0) fail();
    out.append(block, static_cast<size_t>(count));
  }
  return out;
}

void visit_tar(const std::string& path, const TarVisitor& visit) {
  TarReader reader(path);
  while (const auto name = reader.next()) visit(*name, [&] { return reader.bytes(); });
}

}  // namespace trivet::farm
