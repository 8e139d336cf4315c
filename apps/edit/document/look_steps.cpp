#include "apps/edit/document/look_steps.h"

#include <algorithm>
#include <utility>

namespace trivet::edit {

void LookSteps::learn(const Looks& from, const Looks& to) {
  for (const ObjectId id : from.differing(to)) {
    if (std::find(m_known.begin(), m_known.end(), id) == m_known.end()) m_known.push_back(id);
    m_now.change(id, to.of(id));
  }
  if (from.collections == to.collections) return;
  m_knows_collections = true;
  m_now.collections = to.collections;
}

Looks LookSteps::now(Looks looks) const {
  for (const ObjectId id : m_known) looks.change(id, m_now.of(id));
  if (m_knows_collections) looks.collections = m_now.collections;
  return looks;
}

void LookSteps::undo() {
  const LookStep& step = m_steps[--m_num_done];
  learn(step.now, step.before);
}

void LookSteps::redo() {
  const LookStep& step = m_steps[m_num_done++];
  learn(step.before, step.now);
}

void LookSteps::add(LookStep step) {
  Looks before = now(step.before);
  step.now = before.changed(step.before, step.now);
  step.before = std::move(before);
  learn(step.before, step.now);
  m_end = step.after;
  m_steps.resize(m_num_done);
  m_steps.push_back(std::move(step));
  ++m_num_done;
}

void LookSteps::follow_new_step() {
  m_end = static_cast<size_t>(-1);
  m_steps.resize(m_num_done);
}

const LookStep* LookSteps::to_undo(size_t session_done) const {
  const bool is_next = m_num_done > 0 && m_steps[m_num_done - 1].after == session_done;
  return is_next ? &m_steps[m_num_done - 1] : nullptr;
}

const LookStep* LookSteps::to_redo(size_t session_done) const {
  const bool is_next = m_num_done < m_steps.size() && m_steps[m_num_done].after == session_done;
  return is_next ? &m_steps[m_num_done] : nullptr;
}

History LookSteps::merged(const std::vector<std::string>& labels, size_t session_done) const {
  History out;
  auto look = m_steps.begin();
  for (size_t i = 0;; ++i) {
    for (; look != m_steps.end() && look->after == i; ++look) out.steps.push_back(look->name);
    if (i == num_seen(labels.size())) break;
    out.steps.push_back(labels[i]);
  }
  out.num_done = session_done + m_num_done;
  return out;
}

}  // namespace trivet::edit
