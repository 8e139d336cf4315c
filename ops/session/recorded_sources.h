// Where the models of a restored session come from.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/session/recorded.h"

namespace trivet {

/// Models as a journal recorded them: from their files, else as the journal keeps them, else from
/// their files though they have changed, else boxes of their size. Safe to use from many threads.
class RecordedSources {
 public:
  /// @param journal  its path. @param files  as models_in_folder().
  RecordedSources(std::string journal, ModelSource files);

  /// From here on these are asked for.
  void expect(const RecordedModels& models);
  /// From here on models come from their files alone.
  void end();

  /// @throws Error  what `files` throws, of a model that is not expected.
  Model model(const std::string& name, const Tessellation& tessellation);

  /// Sentences about models that are not as they were, sorted by name.
  std::vector<Sentence> notes() const;

 private:
  Model from_file(const ModelRequest& request) const {
    return m_files(request.name, request.tessellation);
  }
  std::optional<Model> kept(const RecordedModel& wanted) const;
  void note(const ModelRequest& request, const Sentence& what);

  const std::string m_journal;
  const ModelSource m_files;
  mutable std::mutex m_mutex;
  std::map<ModelRequest, RecordedModel> m_expected;
  std::map<ModelRequest, Sentence> m_notes;
};

}  // namespace trivet
