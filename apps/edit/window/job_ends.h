// Windows ask here for a call when a job of the document has ended.
#pragma once

#include <functional>
#include <map>

#include "apps/edit/document/document.h"

namespace trivet::edit {

class JobEnds : public QObject {
 public:
  explicit JobEnds(Document& document) {
    connect(&document, &Document::finished, this, [this](quint64 job, bool ok) {
      const auto waiting = m_waiting.extract(job);
      if (!waiting.empty()) waiting.mapped()(ok);
    });
  }

  /// Calls then(ok) once, when this job ends.
  void when_finished(Document::Job job, std::function<void(bool)> then) {
    m_waiting[job] = std::move(then);
  }

 private:
  std::map<Document::Job, std::function<void(bool)>> m_waiting;
};

}  // namespace trivet::edit
