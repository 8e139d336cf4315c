#include "ops/files/arrange/arrange_operation.h"

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/arrange/as_operation.h"
#include "ops/files/arrange/arrangement_json.h"
#include "ops/operations/arrange_problem.h"

namespace trivet {
namespace {

// Names mean what the scene has when it is solved.
class WrittenProblem : public ArrangeProblem {
 public:
  explicit WrittenProblem(nlohmann::json document) : m_document(std::move(document)) {}

  OperationResult solve(Transaction& transaction, const SettleOptions& options,
                        const RunContext& context) const override {
    const Scene& scene = transaction.scene();
    std::vector<std::string> names, unplaced;
    names.reserve(scene.ids().size());
    for (const ObjectId id : scene.ids()) {
      const Object& object = scene.at(id);
      names.push_back(object.name);
      if (!object.placed && !object.fixed) unplaced.push_back(object.name);
    }
    try {
      const Arrangement arrangement =
          read_arrangement(JsonPlace(m_document, "arrange"), ArrangementPlace::InSection,
                           ProblemNames(std::move(names)), unplaced);
      return arrange_as_operation(transaction, arrangement, options, context);
    } catch (const Error& e) {
      if (e.kind() != Error::Kind::BadInput) throw;
      Refusal why{Refusal::Cause::InvalidArgument};
      why.detail = e.what();
      return refused(std::move(why));
    }
  }

  std::string json() const override { return m_document.dump(); }

 private:
  nlohmann::json m_document;  // without "op"
};

// The first thing as it is named.
std::string first_of(const nlohmann::json& document) {
  const auto things = document.find("things");
  if (things == document.end() || things->empty()) return "*";
  const nlohmann::json& first = things->front();
  return first.value("object", first.value("objects", ""));
}

}  // namespace

ArrangeOperation read_arrange(const JsonPlace& place) {
  read_arrangement(place, ArrangementPlace::InOperation, ProblemNames(), {});
  nlohmann::json document = place.value();
  document.erase("op");
  ArrangeOperation out;
  out.object = first_of(document);
  out.problem = std::make_shared<WrittenProblem>(std::move(document));
  return out;
}

void check_names(const JsonPlace& arrange, const std::set<std::string>& names) {
  const std::vector<std::string> all(names.begin(), names.end());
  read_arrangement(arrange, ArrangementPlace::InOperation, ProblemNames(all), all);
}

}  // namespace trivet
