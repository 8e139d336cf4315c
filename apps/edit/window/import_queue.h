// Models that are imported one after another, and which of them could not be.
#pragma once

#include <QStringList>
#include <deque>
#include <vector>

#include "apps/edit/window/job_ends.h"

namespace trivet::edit {

class ImportQueue : public QObject {
  Q_OBJECT

 public:
  ImportQueue(Document& document, JobEnds& ends) : m_document(document), m_ends(ends) {}

  /// Imports these after those that wait.
  void add(std::vector<ImportModel> models);

 Q_SIGNALS:
  void last_imported();
  /// Several were chosen. Messages of single files were shown only until the next one began.
  void some_refused(const QStringList& files);

 private:
  void next();

  Document& m_document;
  JobEnds& m_ends;
  std::deque<ImportModel> m_waiting;
  size_t m_num_chosen = 0;
  QStringList m_refused;
};

}  // namespace trivet::edit
