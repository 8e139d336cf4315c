// Transactions: steps that are done together or not at all.
#include "apps/python/module/bindings.h"
#include "apps/python/module/errors.h"
#include "apps/python/module/made_by_functions.h"

namespace trivet::python {
namespace {

using namespace py::literals;

// Holds the scene for its thread from enter() to leave(); taken back when it is lost between them.
class Transaction {
 public:
  explicit Transaction(std::shared_ptr<SharedScene> scene) : m_scene(std::move(scene)) {}
  ~Transaction() {
    if (!m_open) return;
    m_open->is_abandoned = true;
    m_scene->take_back_abandoned();
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void enter() {
    check_closed();
    auto open = std::make_shared<OpenTransaction>();
    open->guard = std::make_unique<SceneGuard>(*m_scene, SceneGuard::Use::Change);
    check_closed();  // again, as it may have been entered while this waited
    open->begin = m_scene->session().num_done();
    m_scene->transactions.push_back(open);
    m_open = std::move(open);
  }
  void leave(bool keep) {
    if (!m_open) raise("SceneBusy", "the transaction is not open");
    m_open->guard->check_own("the transaction");
    if (m_scene->is_dragged) raise("SceneBusy", "an object is being dragged");
    if (m_scene->transactions.back() != m_open)
      raise("SceneBusy", "another transaction within this one is open; accepted: after its end");
    m_open.reset();
    m_scene->end_transaction(keep);
  }

 private:
  void check_closed() const {
    if (m_open) raise("SceneBusy", "the transaction is open already");
  }

  std::shared_ptr<SharedScene> m_scene;
  std::shared_ptr<OpenTransaction> m_open;
};

}  // namespace

void bind_transaction(py::module_& m, SceneClass& scene) {
  py::class_<Transaction>(m, "Transaction", made_by_functions())
      .def("enter", &Transaction::enter)
      .def("leave", &Transaction::leave, "keep"_a);
  scene.def("transaction", [](std::shared_ptr<SharedScene> self) {
    return std::make_unique<Transaction>(std::move(self));
  });
}

}  // namespace trivet::python
