#include "apps/edit/window/import_queue.h"

#include <QFileInfo>

namespace trivet::edit {

void ImportQueue::add(std::vector<ImportModel> models) {
  m_refused.clear();
  for (ImportModel& model : models) m_waiting.push_back(std::move(model));
  m_num_chosen = m_waiting.size();
  next();
}

void ImportQueue::next() {
  if (m_waiting.empty()) {
    if (m_num_chosen > 1 && !m_refused.isEmpty()) Q_EMIT some_refused(m_refused);
    return;
  }
  const ImportModel model = std::move(m_waiting.front());
  m_waiting.pop_front();
  m_ends.when_finished(m_document.import_model(model), [this, file = model.file](bool ok) {
    if (ok && m_waiting.empty()) Q_EMIT last_imported();
    if (!ok) m_refused << QFileInfo(QString::fromStdString(file)).fileName();
    next();
  });
}

}  // namespace trivet::edit
