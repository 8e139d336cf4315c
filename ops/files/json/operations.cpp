#include "ops/files/json/operations.h"

#include "core/base/nearest_name.h"
#include "core/base/quoted.h"
#include "ops/files/arrange/operation.h"
#include "ops/files/json/material_json.h"
#include "ops/operations/validate.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

// "a", "b" or "c"
Sentence quoted_words(const Accepts& accepts) {
  Sentence out = quoted(accepts.words[0]);
  for (size_t k = 1; k < accepts.words.size() && accepts.words[k]; ++k) {
    const bool is_last = k + 1 == accepts.words.size() || !accepts.words[k + 1];
    out = say(is_last ? "%1 or %2" : "%1, %2", out, quoted(accepts.words[k]));
  }
  return out;
}

std::string read_name(const JsonPlace& place, const Field& field) {
  std::string name = place.text();
  if (field.accepts.sort == Sort::NewName && name == "floor")
    place.refuse("any name but \"floor\", which is the floor");
  return name;
}

double read_number(const JsonPlace& place, const Accepts& accepts) {
  // A value that stands for none is a default, not a number that can be given.
  return accepts.none ? place.number(accepts.lower, accepts.upper) : place.number();
}

std::uint64_t read_whole(const JsonPlace& place, const Accepts& accepts) {
  const auto& value = place.value();
  const double given = value.is_number_integer() ? value.get<double>() : accepts.lower - 1;
  if (given < accepts.lower || given > accepts.upper)
    place.refuse(
        say("a whole number from %1 to %2", short_number(accepts.lower),
            accepts.upper == static_cast<double>(kMaxSeed) ? "2^53" : short_number(accepts.upper)));
  return value.get<std::uint64_t>();
}

/// Reads one value; ranges are left to find_invalid_argument().
struct Read {
  const JsonPlace& place;
  const Field& field;

  void operator()(bool* v) const { *v = place.boolean(); }
  void operator()(int* v) const { *v = static_cast<int>(read_whole(place, field.accepts)); }
  void operator()(std::uint64_t* v) const { *v = read_whole(place, field.accepts); }
  void operator()(double* v) const { *v = read_number(place, field.accepts); }
  void operator()(std::string* v) const { *v = read_name(place, field); }
  void operator()(Vec2* v) const { *v = read_vec2(place); }
  void operator()(Vec3* v) const { *v = read_vec3(place); }
  void operator()(Rotation* v) const { *v = read_rotation(place); }
  void operator()(PhysicsMaterial* v) const { *v = read_material(place); }
  void operator()(std::vector<std::string>* v) const {
    for (const JsonPlace& item : place.items()) v->push_back(item.text());
  }
  void operator()(std::vector<Vec2>* v) const {
    if (field.accepts.sort == Sort::Region) {
      *v = read_region(place);
      return;
    }
    for (const JsonPlace& item : place.items()) v->push_back(read_vec2(item));
  }
  void operator()(std::vector<Vec3>* v) const {
    v->clear();  // forms may begin with some
    for (const JsonPlace& item : place.items()) v->push_back(read_vec3(item));
  }
  template <class T>
  void operator()(std::optional<T>* v) const {
    const char* const word = field.accepts.words[0];
    if (word && place.value() == word) return;
    if (word && !place.value().is_array())
      place.refuse(say("%1 or a point [x, y]", quoted_words(field.accepts)));
    (*this)(&v->emplace());
  }
  void operator()(const WordSlot& slot) const {
    const auto& words = field.accepts.words;
    for (size_t k = 0; k < words.size() && words[k]; ++k)
      if (place.value() == words[k]) return slot.set(slot.value, static_cast<int>(k));
    place.refuse(quoted_words(field.accepts));
  }
};

struct Write {
  const Field& field;

  Json operator()(const Rotation* q) const { return {q->w, q->x, q->y, q->z}; }
  Json operator()(const Vec2* v) const { return {v->x(), v->y()}; }
  Json operator()(const Vec3* v) const { return {v->x(), v->y(), v->z()}; }
  Json operator()(const PhysicsMaterial* v) const { return material_json(*v); }
  Json operator()(const WordSlot& slot) const {
    const int word = slot.get(slot.value);
    return word < 0 ? Json() : Json(field.accepts.words[static_cast<size_t>(word)]);
  }
  template <class T>
  Json operator()(const std::optional<T>* v) const {
    if (*v) return (*this)(&**v);
    return field.accepts.words[0] ? Json(field.accepts.words[0]) : Json();
  }
  template <class T>
  Json operator()(const std::vector<T>* v) const {
    Json out = Json::array();
    for (const T& one : *v) out.push_back((*this)(&one));
    return out.empty() ? Json() : out;
  }
  template <class T>
  Json operator()(const T* v) const {
    return *v;
  }
};

/// Tells which forms have a key that this one has not.
Sentence where_it_goes(const OperationTable& table, const Field& field) {
  for (size_t f = 0; f < table.forms.size(); ++f) {
    const Form& form = table.forms[f];
    if (!field.is_in(f) || form.marks.empty() || form.marks[0] == std::string(field.key)) continue;
    Sentence words;
    for (const char* const word : form.words)
      words = words.empty() ? say(": %1", quoted(word)) : say("%1 or %2", words, quoted(word));
    return say("; %1 goes with %2%3", quoted(field.key), quoted(form.marks[0]), words);
  }
  return {};
}

void expect_keys(const JsonPlace& place, const OperationTable& table, size_t form) {
  const auto explain = [&](const std::string& key) {
    const Field* const field = table.find(key);
    return field ? where_it_goes(table, *field) : Sentence();
  };
  place.expect_object(table.keys(form, true), table.keys(form, false), explain);
}

// Without anything that chooses a form, whatever all forms have.
[[noreturn]] void refuse_choice(const JsonPlace& place, const OperationTable& table) {
  std::vector<const char*> required{"op"}, optional;
  for (const Field& field : table.fields)
    if (field.is_in(0) && field.is_in(table.forms.size() - 1))
      (field.required ? required : optional).push_back(field.key);
  place.expect_object(required, optional, [](const std::string&) { return Sentence(); });
  place.fail(table.choice);
}

Operation read_by(const JsonPlace& place, const Operation& kind, const std::string& op) {
  const OperationTable& table = table_of(kind);
  const auto given = [&](const char* key) { return place.find(key).has_value(); };
  const auto word = [&](const char* key) {
    const auto& value = place.at(key).value();
    return value.is_string() ? value.get<std::string>() : std::string();
  };
  const auto form = table.chosen(op, given, word);
  if (!form) refuse_choice(place, table);
  expect_keys(place, table, *form);
  Operation operation = kind;
  if (table.forms[*form].begin) table.forms[*form].begin(data_of(operation));
  for (const Field& field : table.fields)
    if (field.is_in(*form))
      if (const auto found = place.find(field.key))
        std::visit(Read{*found, field}, field.slot(data_of(operation)));
  if (const auto found = find_invalid_argument(operation)) {
    const auto where = place.find(found->key.c_str());
    if (!where) place.fail(in_words(*found));  // a default that does not fit
    found->why.empty() ? where->refuse(found->accepted) : where->fail(found->why);
  }
  return operation;
}

[[noreturn]] void refuse_unknown_op(const JsonPlace& op) {
  std::vector<std::string> names;
  for (const Operation& kind : all_kinds())
    for (const Form& form : table_of(kind).forms)
      if (names.empty() || names.back() != form.op) names.emplace_back(form.op);
  std::string list;
  for (size_t k = 0; k < names.size(); ++k)
    list.append(k == 0 ? "\"" : k + 1 == names.size() ? " or \"" : ", \"") += names[k] + '"';
  const std::string given = op.value().is_string() ? op.value().get<std::string>() : "";
  op.refuse(say("%1%2", list, did_you_mean(given, names)));
}

}  // namespace

Operation read_operation(const JsonPlace& place) {
  if (!place.value().is_object()) place.refuse("an object with the keys op, object, ...");
  const JsonPlace op = place.at("op");
  for (const Operation& kind : all_kinds())
    for (const Form& form : table_of(kind).forms)
      if (op.value() == form.op) {
        if (std::holds_alternative<ArrangeOperation>(kind)) return read_arrange(place);
        return read_by(place, kind, form.op);
      }
  refuse_unknown_op(op);
}

Json value_json(const Field& field, const Slot& slot) { return std::visit(Write{field}, slot); }

Json operation_json(const Operation& operation) {
  Json json = {{"op", op_name(operation)}};
  if (const auto* const arrange = std::get_if<ArrangeOperation>(&operation)) {
    json.update(Json::parse(arrange->problem->json()));
    return json;
  }
  const OperationTable& table = table_of(operation);
  void* const data = const_cast<void*>(data_of(operation));  // slots are only read here
  const size_t form = table.form_of(data);
  Operation usual = all_kinds()[operation.index()];
  if (table.forms[form].begin) table.forms[form].begin(data_of(usual));
  for (const Field& field : table.fields) {
    if (!field.is_in(form)) continue;
    Json value = value_json(field, field.slot(data));
    const bool is_usual = value == value_json(field, field.slot(data_of(usual)));
    if (field.required || field.is_written || !is_usual) json[field.key] = std::move(value);
  }
  return json;
}

}  // namespace trivet
