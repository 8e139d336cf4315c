// Jobs on many objects of the document's thread.
#include "apps/edit/document/document.h"
#include "apps/edit/document/engine.h"
#include "apps/edit/document/words.h"
#include "core/scene/transaction.h"

namespace trivet::edit {
namespace {

OperationResult perform_group(Transaction& all, const OperationGroup& group,
                              const SettleOptions& options, const RunContext& context) {
  Transaction one(all);
  OperationResult result;
  for (const Operation& operation : group) {
    result = perform(one, operation, options, context);
    if (!result.ok()) return result;
  }
  one.commit();
  return result;
}

}  // namespace

// Tries the groups on a copy of the scene, one after another, then does those that can be done as
// one step.
bool Engine::perform_groups(const std::string& what, const ManyObjects& many) {
  Scene trial = m_opened->session.scene();
  Transaction all(trial);
  std::vector<Operation> done;
  std::vector<std::string> names;
  std::optional<OperationResult> refused;  // the first
  size_t refused_group = 0;
  bool stopped = false;  // by the user: what is done by then stays
  for (size_t i = 0; i < many.groups.size() && !stopped; ++i) {
    tell_progress(what, i, many.groups.size());
    OperationResult result = perform_group(all, many.groups[i], settle_options(), context());
    if (result.ok()) {
      done.insert(done.end(), many.groups[i].begin(), many.groups[i].end());
      names.push_back(many.names[i]);
      continue;
    }
    stopped = result.status == OperationResult::Status::Cancelled;
    if (stopped) break;
    if (!refused) refused_group = i;
    if (!refused) refused = std::move(result);
  }
  if (done.empty()) {
    if (stopped) throw Cancelled();
    if (refused) tell(*refused, many.groups[refused_group].back());
    return false;
  }
  if (stopped) m_cancel = false;
  show_progress(what, 0, 0);
  if (!perform_all(done, many.select ? names : std::vector<std::string>())) return false;
  if (stopped)
    tell(Message{Message::Kind::Info,
                 Document::tr("%1: stopped after %2 of %3, which stay")
                     .arg(QString::fromStdString(what), QString::number(names.size()),
                          QString::number(many.groups.size()))
                     .toStdString(),
                 {},
                 {}});
  else if (refused)
    tell(Message{Message::Kind::Info,
                 Document::tr("%1: %2 of %3; the others were refused, the first: %4")
                     .arg(QString::fromStdString(what), QString::number(names.size()),
                          QString::number(many.groups.size()),
                          QString::fromStdString(reason_in_words(*refused)))
                     .toStdString(),
                 {},
                 {}});
  return true;
}

}  // namespace trivet::edit
