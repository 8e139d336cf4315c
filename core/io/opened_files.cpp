#include "core/io/opened_files.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

namespace trivet {
namespace {

using FileId = std::pair<dev_t, ino_t>;

// nullopt: there is no such file.
std::optional<FileId> id_of(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileId(status.st_dev, status.st_ino);
}

std::string absolute(const std::string& path) {
  std::error_code failed;
  const auto out = std::filesystem::absolute(path, failed);
  return failed ? path : out.lexically_normal().string();
}

std::string canonical_path(const std::string& path) {
  std::error_code failed;
  const auto out = std::filesystem::weakly_canonical(path, failed);
  return failed ? path : out.string();
}

class Registry {
 public:
  void note(const std::string& model, const std::vector<std::string>& files) {
    const auto own = id_of(model);
    const std::lock_guard lock(m_mutex);
    std::vector<std::string>& known = m_files_of[absolute(model)];
    for (const std::string& file : files) {
      const auto id = id_of(file);
      if (!id || id == own || std::find(known.begin(), known.end(), file) != known.end()) continue;
      known.push_back(file);
      m_at_path[canonical_path(file)].push_back(model);
      m_by_id[*id].push_back({absolute(file), model});
    }
  }
  std::optional<std::vector<std::string>> files_of(const std::string& model) const {
    const std::lock_guard lock(m_mutex);
    const auto it = m_files_of.find(absolute(model));
    return it == m_files_of.end() ? std::nullopt : std::optional(it->second);
  }
  std::string owner_of(const std::string& file, const std::string& but) const {
    const auto id = id_of(file);
    if (!id) return "";
    const auto exempt = id_of(but);
    const auto counts = [&](const std::string& model) { return !exempt || id_of(model) != exempt; };
    const std::lock_guard lock(m_mutex);
    if (const auto it = m_at_path.find(canonical_path(file)); it != m_at_path.end())
      for (const std::string& model : it->second)
        if (counts(model)) return model;
    if (const auto it = m_by_id.find(*id); it != m_by_id.end())
      for (const Opened& opened : it->second)
        if (id_of(opened.path) == id && counts(opened.model)) return opened.model;
    return "";
  }

 private:
  // A new file may have the number of one that is gone: the path tells.
  struct Opened {
    std::string path, model;
  };

  mutable std::mutex m_mutex;
  std::map<std::string, std::vector<std::string>> m_files_of;  // by absolute path
  std::map<std::string, std::vector<std::string>> m_at_path;   // models, by canonical path
  std::map<FileId, std::vector<Opened>> m_by_id;
};

Registry& registry() {
  static Registry* const out = new Registry;  // for threads that outlive main()
  return *out;
}

}  // namespace

void note_opened(const std::string& model, const std::vector<std::string>& files) {
  registry().note(model, files);
}

std::optional<std::vector<std::string>> files_opened_for(const std::string& model) {
  return registry().files_of(model);
}

std::string model_that_opened(const std::string& file, const std::string& but) {
  return registry().owner_of(file, but);
}

}  // namespace trivet
