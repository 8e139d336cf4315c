// A document without windows.
#pragma once

#include <gtest/gtest.h>

#include "apps/edit/document/document.h"
#include "apps/edit_document/boxes.h"
#include "support/temporary_folder.h"

namespace trivet::edit::test {

using trivet::test::TemporaryFolder;

/// Writes the models of a demo to this folder.
void write_models(const std::string& demo, const TemporaryFolder& folder);

/// A document, recording its messages.
class Recorder {
 public:
  explicit Recorder(const std::string& recovery_folder, BackendOptions detection = {});

  Document& operator*() const { return *m_document; }
  Document* operator->() const { return m_document.get(); }
  /// Waits for completion. @return whether the last job succeeded.
  bool done(Document::Job job);
  const std::vector<Message>& messages() const { return m_messages; }
  /// As `name`; fixed objects stand at the origin, others are not placed.
  void import(const std::string& file, const std::string& name, bool fixed = false);
  std::string last_text() const { return m_messages.empty() ? "" : m_messages.back().text; }
  void forget() { m_messages = {}, m_finished = {}; }
  const Object& object(const std::string& name) const;
  ObjectId id(const std::string& name) const;

 private:
  std::unique_ptr<Document> m_document;
  std::vector<Message> m_messages;
  std::vector<std::pair<quint64, bool>> m_finished;
};

}  // namespace trivet::edit::test
