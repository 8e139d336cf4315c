#include "ops/files/arrange/operation.h"

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/arrange/as_operation.h"
#include "ops/files/arrange/arrangement_json.h"
#include "ops/files/arrange/section.h"
#include "ops/operations/arrange.h"

namespace trivet {
namespace {

Arrangement section_of(const nlohmann::json& document, const Scene& scene) {
  std::vector<std::string> names, unplaced;
  names.reserve(scene.ids().size());
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    names.push_back(object.name);
    if (!object.placed && !object.fixed) unplaced.push_back(object.name);
  }
  return read_arrangement(JsonPlace(document, "arrange"), ArrangementPlace::InSection,
                          ProblemNames(std::move(names)), unplaced);
}

// Names mean what the scene has when it is solved.
class WrittenProblem : public ArrangeProblem {
 public:
  explicit WrittenProblem(nlohmann::json document) : m_document(std::move(document)) {}

  OperationResult solve(Transaction& transaction, const SettleOptions& options,
                        const RunContext& context) const override {
    try {
      return arrange_as_operation(transaction, section_of(m_document, transaction.scene()), options,
                                  context);
    } catch (const Error& e) {
      if (e.kind() != Error::Kind::BadInput) throw;
      Refusal why{Refusal::Cause::InvalidArgument};
      why.detail = e.sentence();
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

ArrangeOperation operation_of(nlohmann::json document) {
  ArrangeOperation out;
  out.object = first_of(document);
  out.problem = std::make_shared<WrittenProblem>(std::move(document));
  return out;
}

}  // namespace

ArrangeOperation read_arrange(const JsonPlace& place) {
  read_arrangement(place, ArrangementPlace::InOperation, ProblemNames(), {});
  nlohmann::json document = place.value();
  document.erase("op");
  return operation_of(std::move(document));
}

Arrangement parse_arrange_section(const std::string& json, const Scene& scene) {
  return section_of(parse_json(json, "arrange"), scene);
}

ArrangeOperation arrange_operation(const std::string& json) {
  nlohmann::json document = parse_json(json, "arrange");
  read_arrangement(JsonPlace(document, "arrange"), ArrangementPlace::InSection, ProblemNames(), {});
  return operation_of(std::move(document));
}

void check_names(const JsonPlace& arrange, const std::vector<std::string>& names) {
  read_arrangement(arrange, ArrangementPlace::InOperation, ProblemNames(names), names);
}

}  // namespace trivet
