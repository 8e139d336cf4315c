// Tables of arguments: what is made of them agrees with them, for every operation there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "ops/files/json/operation_schema.h"
#include "ops/files/json/operations.h"
#include "ops/operations/validate.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

// A value that is accepted and is no default.
struct Fill {
  const Field& field;

  void operator()(bool* v) const { *v = field.required || !*v; }
  void operator()(int* v) const { *v = static_cast<int>(number()); }
  void operator()(std::uint64_t* v) const { *v = static_cast<std::uint64_t>(number()); }
  void operator()(double* v) const { *v = number(); }
  void operator()(std::string* v) const { *v = "some"; }
  void operator()(Vec2* v) const { *v = {0.25, 0.5}; }
  void operator()(Vec3* v) const { *v = {0.25, 0.5, 0.75}; }
  void operator()(Rotation* v) const { *v = {0, 1, 0, 0}; }
  void operator()(PhysicsMaterial* v) const { v->friction = 0.25; }
  void operator()(std::vector<Vec2>* v) const { *v = {{0, 0}, {1, 0}, {1, 1}}; }
  template <class T>
  void operator()(std::vector<T>* v) const {
    (*this)(&v->emplace_back());
  }
  template <class T>
  void operator()(std::optional<T>* v) const {
    (*this)(&v->emplace());
  }
  void operator()(const WordSlot& slot) const {
    slot.set(slot.value, std::max(0, slot.get(slot.value)));
  }

 private:
  double number() const {
    return std::max(field.accepts.lower, std::min(field.accepts.upper, 2.0));
  }
};

// As Fill, but not accepted; false: every value of that type is.
struct Spoil {
  const Field& field;

  bool operator()(double* v) const { return *v = 2 * field.accepts.upper + 1, true; }
  bool operator()(std::uint64_t* v) const { return *v = ~std::uint64_t{0}, true; }
  bool operator()(Vec2* v) const { return *v = Vec2::Constant(NAN), true; }
  bool operator()(Vec3* v) const { return *v = Vec3::Constant(NAN), true; }
  bool operator()(Rotation* v) const { return *v = {2, 0, 0, 0}, true; }
  bool operator()(std::vector<Vec2>* v) const { return *v = {Vec2::Constant(NAN)}, true; }
  bool operator()(std::vector<Vec3>* v) const { return *v = {Vec3::Constant(NAN)}, true; }
  bool operator()(std::optional<double>* v) const { return (*this)(&v->emplace()); }
  bool operator()(std::optional<Vec2>* v) const { return (*this)(&v->emplace()); }
  bool operator()(std::optional<Vec3>* v) const { return (*this)(&v->emplace()); }
  template <class Other>
  bool operator()(Other) const {
    return false;
  }
};

/// Calls visit(operation, table, form) with one operation of each form of each kind.
template <class Visit>
void for_all_forms(const Visit& visit) {
  for (const Operation& kind : all_kinds()) {
    if (std::holds_alternative<ArrangeOperation>(kind)) continue;
    const OperationTable& table = table_of(kind);
    for (size_t f = 0; f < table.forms.size(); ++f) {
      Operation one = kind;
      if (table.forms[f].begin) table.forms[f].begin(data_of(one));
      for (const Field& field : table.fields)
        if (field.is_in(f) && field.required) std::visit(Fill{field}, field.slot(data_of(one)));
      SCOPED_TRACE(std::string(table.forms[f].op) + ", form " + std::to_string(f));
      visit(one, table, f);
    }
  }
}

std::string complaint(const Json& operation) {
  try {
    const nlohmann::json document = nlohmann::json::parse(operation.dump());
    read_operation(JsonPlace(document, "a.json"));
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

Operation read(const Json& operation) {
  const nlohmann::json document = nlohmann::json::parse(operation.dump());
  return read_operation(JsonPlace(document, "a.json"));
}

TEST(Tables, FormsHoldOfWhatTheyBegin) {
  int num_forms = 0;
  for_all_forms([&](const Operation& one, const OperationTable& table, size_t form) {
    ++num_forms;
    EXPECT_EQ(table.form_of(data_of(one)), form);
    EXPECT_STREQ(op_name(one), table.forms[form].op);
    // MOVE-JOINT asks for one of three arguments.
    EXPECT_EQ(find_invalid_argument(one).has_value(), op_name(one) == std::string("move_joint"));
  });
  EXPECT_GE(num_forms, 22);
}

TEST(Tables, EveryArgumentIsReadAsItIsWritten) {
  for_all_forms([](const Operation& one, const OperationTable& table, size_t form) {
    for (const Field& field : table.fields) {
      if (!field.is_in(form)) continue;
      Operation filled = one;
      if (std::string(field.key) == "chord" || std::string(field.key) == "facet_angle_deg")
        std::get<AppendOperation>(filled).model = "a.step";
      std::visit(Fill{field}, field.slot(data_of(filled)));
      if (auto* const drape = std::get_if<DrapeOperation>(&filled)) {
        if (!drape->material.empty()) drape->material = drape->path.empty() ? "wool" : "lead";
        if (drape->thickness) drape->thickness = 1e-3;  // thicker than cells is refused
        drape->pins.resize(std::max(drape->pins.size(), drape->held_by.size()), Vec3::Zero());
      }
      if (auto* const joint = std::get_if<MoveJointOperation>(&filled))
        if (!joint->to && !joint->by && !joint->until) joint->to = 0.25;
      const Json json = operation_json(filled);
      EXPECT_TRUE(json.contains(field.key)) << field.key;
      EXPECT_EQ(operation_json(read(json)), json) << field.key;
    }
  });
}

TEST(Tables, DefaultsAreLeftOut) {
  for_all_forms([](const Operation& one, const OperationTable& table, size_t form) {
    const Json json = operation_json(one);
    for (const Field& field : table.fields)
      if (field.is_in(form) && !field.required && !field.is_written) {
        EXPECT_FALSE(json.contains(field.key)) << field.key;
      }
  });
}

TEST(Tables, MissingAndUnknownKeysAreNamed) {
  for_all_forms([](const Operation& one, const OperationTable& table, size_t form) {
    Json wrong = operation_json(one);
    wrong["nonsense"] = 1;
    const std::string accepted = std::string("/nonsense: unknown key; accepted: op, ") +
                                 (table.find("object") ? "object" : table.keys(form, false)[0]);
    EXPECT_NE(complaint(wrong).find(accepted), std::string::npos) << complaint(wrong);
    for (const char* const key : table.keys(form, true)) {
      Json without = operation_json(one);
      without.erase(key);
      EXPECT_NE(complaint(without).find("missing"), std::string::npos) << key << complaint(without);
    }
  });
}

TEST(Tables, RangesAreChecked) {
  int num_ranges = 0;
  for_all_forms([&](const Operation& one, const OperationTable& table, size_t form) {
    for (const Field& field : table.fields) {
      Operation spoiled = one;
      if (!field.is_in(form) || !std::visit(Spoil{field}, field.slot(data_of(spoiled)))) continue;
      const auto found = find_invalid_argument(spoiled);
      ASSERT_TRUE(found) << field.key;
      EXPECT_EQ(found->key, field.key);
      EXPECT_FALSE(found->accepted.empty());
      ++num_ranges;
    }
  });
  EXPECT_GT(num_ranges, 30);
}

TEST(Tables, KeysOfOtherFormsSayWhereTheyGo) {
  EXPECT_NE(complaint({{"op", "put"}, {"object", "a"}, {"position", {0, 0, 1}}, {"keep", 0.1}})
                .find("\"keep\" goes with \"on\""),
            std::string::npos);
  EXPECT_NE(complaint({{"op", "turn"}, {"object", "a"}, {"angle_deg", 5}, {"axis", {0, 0, 1}}})
                .find("\"axis\" goes with \"about\": \"line\" or \"point\""),
            std::string::npos);
}

TEST(Tables, SchemaRequiresWhatIsRequired) {
  const Json schemas = operation_schemas();
  size_t k = 0;
  for (const Operation& kind : all_kinds())
    for (size_t f = 0; f < table_of(kind).forms.size(); ++f, ++k) {
      if (std::holds_alternative<ArrangeOperation>(kind)) continue;
      const Json& schema = schemas[k];
      for (const bool required : {true, false})
        for (const char* const key : table_of(kind).keys(f, required))
          EXPECT_TRUE(schema["properties"].contains(key)) << key;
      EXPECT_GE(schema["required"].size(), table_of(kind).keys(f, true).size());
    }
  EXPECT_EQ(schemas.size(), k);
}

}  // namespace
}  // namespace trivet
