// Tar files, by libarchive: the same members are the same bytes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace trivet::farm {

using TarSink = std::function<void(std::string_view bytes)>;

/// POSIX ustar; no times, owners or hosts.
class TarWriter {
 public:
  /// @param sink  gets the bytes, in order; what it throws comes out of the calls.
  explicit TarWriter(TarSink sink);
  ~TarWriter();
  TarWriter(const TarWriter&) = delete;
  TarWriter& operator=(const TarWriter&) = delete;

  void add(const std::string& name, std::string_view bytes);
  void finish();

  struct State;  // for the callback of libarchive

 private:
  std::unique_ptr<State> m_state;
};

/// Reads a tar, member after member; what is not asked for is skipped at no cost.
class TarReader {
 public:
  /// @throws Error (BadInput), as all calls, when the file is no tar, or ends early.
  explicit TarReader(std::string path);
  ~TarReader();
  TarReader(const TarReader&) = delete;
  TarReader& operator=(const TarReader&) = delete;

  /// Name of the next member; nullopt at the end.
  std::optional<std::string> next();
  /// Bytes of this member, once.
  std::string bytes();

 private:
  struct State;
  [[noreturn]] void fail() const;

  std::string m_path;
  std::unique_ptr<State> m_state;
};

/// Calls visit(name, read) for each member in order; read() gives its bytes.
/// @throws Error as TarReader.
using TarVisitor =
    std::function<void(const std::string& name, const std::function<std::string()>& read)>;
void visit_tar(const std::string& path, const TarVisitor& visit);

}  // namespace trivet::farm
