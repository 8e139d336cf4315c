#include "apps/trivet/operation_options.h"

#include <algorithm>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/base/quoted.h"
#include "ops/base/refusal.h"
#include "ops/free_places/place_region.h"
#include "ops/operations/validate.h"

namespace trivet::apps {

/// One option and what was given for it.
struct OperationOptions::Option {
  const Field* field;
  CLI::Option* option = nullptr;  // null: several, of a material
  bool flag = false;
  std::vector<double> numbers = {};
  std::vector<std::string> texts = {};
  MaterialArguments material = {};

  bool is_given() const { return option ? option->count() > 0 : material.material().has_value(); }
};

namespace {

std::string name_of(const char* key) {
  std::string out = std::string("--") + key;
  std::replace(out.begin(), out.end(), '_', '-');
  return out;
}

// Keys of layouts become options: "angle_deg" is --angle-deg.
std::string in_options(std::string text, const OperationTable& table) {
  for (const Field& field : table.fields) {
    const std::string key = std::string("\"") + field.key + '"';
    for (size_t at = text.find(key); at != std::string::npos; at = text.find(key))
      text.replace(at, key.size(), name_of(field.key));
  }
  return text;
}

// Help with unit and default, as far as there are some.
std::string help_of(const Field& field, const std::string& usual = "") {
  const std::string unit = field.accepts.unit;
  const std::string said = field.required || usual.empty() ? "" : "default: " + usual;
  if (unit.empty() && said.empty()) return field.help;
  return std::string(field.help) + " (" + unit + (unit.empty() || said.empty() ? "" : "; ") + said +
         ")";
}

std::string shown(const std::vector<double>& values) {
  std::ostringstream out;
  for (size_t k = 0; k < values.size(); ++k) out << (k ? " " : "") << values[k];
  return out.str();
}

/// Adds an option for a value of this type. The default is part of its help.
template <class Option>
struct Add {
  CLI::App& app;
  Option& out;
  const Field& field;

  CLI::Option* operator()(const bool* on) const {
    const std::string name = name_of(field.key);
    // A required switch chooses its form of the operation, and is on there.
    return *on && !field.required ? app.add_flag("--no-" + name.substr(2), out.flag, field.off)
                                  : app.add_flag(name, out.flag, field.help);
  }
  CLI::Option* operator()(const double* v) const {
    return number(field.accepts.none == *v ? help_of(field) : help({*v}));
  }
  CLI::Option* operator()(const std::optional<double>*) const { return number(help_of(field)); }
  CLI::Option* operator()(const int* v) const { return whole(static_cast<double>(*v)); }
  CLI::Option* operator()(const std::uint64_t* v) const { return whole(static_cast<double>(*v)); }
  CLI::Option* operator()(const Vec2* v) const { return vector(2, help({v->x(), v->y()})); }
  CLI::Option* operator()(const Vec3* v) const { return vector(3, help({v->x(), v->y(), v->z()})); }
  CLI::Option* operator()(const Rotation* q) const {
    return vector(4, help({q->w, q->x, q->y, q->z}));
  }
  CLI::Option* operator()(const std::optional<Vec3>*) const { return vector(3, help_of(field)); }
  CLI::Option* operator()(const std::optional<Vec2>*) const {
    const char* const word = field.accepts.words[0];
    if (!word) return vector(2, help_of(field));
    return texts(help_of(field))->expected(1, 2)->type_name(std::string("X Y|") + word);
  }
  CLI::Option* operator()(const std::vector<Vec2>*) const { return list(2); }
  CLI::Option* operator()(const std::vector<Vec3>*) const { return list(3); }
  CLI::Option* operator()(const std::string*) const { return name(); }
  CLI::Option* operator()(const std::optional<std::string>*) const { return name(); }
  CLI::Option* operator()(const std::vector<std::string>*) const {
    return texts(std::string(field.help) + "; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
  }
  CLI::Option* operator()(const WordSlot& slot) const {
    std::vector<std::string> words;
    for (const char* const word : field.accepts.words)
      if (word) words.emplace_back(word);
    const int usual = slot.get(slot.value);
    const std::string help =
        usual < 0 ? std::string(field.help)
                  : std::string(field.help) + "; default: " + words[static_cast<size_t>(usual)];
    return texts(help)->expected(1)->type_name("")->check(one_of(words));
  }
  template <class Material>
  CLI::Option* operator()(const Material*) const {
    add_material_options(app, out.material);
    return nullptr;
  }

 private:
  std::string help(const std::vector<double>& usual) const { return help_of(field, shown(usual)); }
  CLI::Validator range() const { return number_from(field.accepts.lower, field.accepts.upper); }
  CLI::Option* numbers(const std::string& text) const {
    return app.add_option(name_of(field.key), out.numbers, text);
  }
  CLI::Option* texts(const std::string& text) const {
    return app.add_option(name_of(field.key), out.texts, text);
  }
  CLI::Option* number(const std::string& text) const {
    return numbers(text)->expected(1)->type_name("NUMBER")->check(range());
  }
  CLI::Option* whole(double usual) const {
    return numbers(help({usual}))
        ->expected(1)
        ->type_name("INTEGER")
        ->check(integer_from(static_cast<long>(field.accepts.lower),
                             static_cast<long>(field.accepts.upper)));
  }
  CLI::Option* vector(int count, const std::string& text) const {
    const char* const types[] = {"X Y", "X Y Z", "W X Y Z"};
    return numbers(text)->expected(count)->type_name(types[count - 2])->check(range());
  }
  CLI::Option* list(int count) const {
    return numbers(help_of(field))
        ->type_size(count)
        ->type_name(count == 2 ? "X Y ..." : "X Y Z ...")
        ->check(range());
  }
  CLI::Option* name() const { return texts(field.help)->expected(1)->type_name("NAME"); }
};

Vec2 vec2(const std::vector<double>& v, size_t at = 0) { return {v[at], v[at + 1]}; }
Vec3 vec3(const std::vector<double>& v, size_t at = 0) { return {v[at], v[at + 1], v[at + 2]}; }

/// Gives an argument what the option had.
template <class Option>
struct Set {
  const Option& given;

  void operator()(bool* v) const { *v = given.field->required || !*v; }
  void operator()(double* v) const { *v = given.numbers[0]; }
  void operator()(int* v) const { *v = static_cast<int>(given.numbers[0]); }
  void operator()(std::uint64_t* v) const { *v = static_cast<std::uint64_t>(given.numbers[0]); }
  void operator()(std::string* v) const { *v = given.texts[0]; }
  void operator()(Vec2* v) const { *v = vec2(given.numbers); }
  void operator()(Vec3* v) const { *v = vec3(given.numbers); }
  void operator()(std::optional<Vec2>* v) const {
    const char* const word = given.field->accepts.words[0];
    if (!word) return void(*v = vec2(given.numbers));
    if (given.texts[0] == word && given.texts.size() == 1) return;
    *v = point(word);
  }
  void operator()(Rotation* v) const {
    const std::vector<double>& q = given.numbers;
    const auto rotation = unit_rotation({q[0], q[1], q[2], q[3]});
    if (!rotation)
      bad_input(
          "%1: a quaternion w x y z of length zero is not accepted; accepted: any other length",
          name_of(given.field->key));
    *v = *rotation;
  }
  void operator()(std::vector<std::string>* v) const { *v = given.texts; }
  void operator()(std::vector<Vec2>* v) const {
    for (size_t k = 0; k + 1 < given.numbers.size(); k += 2) v->push_back(vec2(given.numbers, k));
    if (given.field->accepts.sort == Sort::Region) *v = region_of(*v);
  }
  void operator()(std::vector<Vec3>* v) const {
    v->clear();  // forms may begin with some
    for (size_t k = 0; k + 2 < given.numbers.size(); k += 3) v->push_back(vec3(given.numbers, k));
  }
  void operator()(PhysicsMaterial* v) const { *v = *given.material.material(); }
  template <class T>
  void operator()(std::optional<T>* v) const {
    (*this)(&v->emplace());
  }
  void operator()(const WordSlot& slot) const {
    const auto& words = given.field->accepts.words;
    for (size_t k = 0; k < words.size() && words[k]; ++k)
      if (given.texts[0] == words[k]) slot.set(slot.value, static_cast<int>(k));
  }

 private:
  Vec2 point(const char* word) const {
    const Accepts& accepts = given.field->accepts;
    const CLI::Validator range = number_from(accepts.lower, accepts.upper);
    for (const std::string& text : given.texts)
      if (given.texts.size() != 2 || !range(const_cast<std::string&>(text)).empty())
        bad_input("%1: %2 is not accepted; accepted: %3, or two numbers from %4 to %5",
                  name_of(given.field->key), quoted(text), word, shown({accepts.lower}),
                  shown({accepts.upper}));
    return {std::stod(given.texts[0]), std::stod(given.texts[1])};
  }
};

}  // namespace

OperationOptions::OperationOptions(CLI::App& app, const Operation& kind, std::string op,
                                   const std::set<std::string>& without)
    : m_app(app), m_table(table_of(kind)), m_kind(kind), m_op(std::move(op)) {
  for (const Field& field : m_table.fields) {
    if (without.count(field.key)) continue;
    for (size_t f = 0; f < m_table.forms.size(); ++f) {
      const Form& form = m_table.forms[f];
      if (m_op != form.op || !field.is_in(f)) continue;
      Operation sample = m_kind;
      if (form.begin) form.begin(data_of(sample));
      add(field, std::move(sample));
      break;
    }
  }
}

OperationOptions::~OperationOptions() = default;

void OperationOptions::add(const Field& field, Operation sample) {
  Option& added = *m_options.emplace_back(std::make_unique<Option>(Option{&field}));
  // The default of a word is that of the plain form.
  const bool is_word = field.accepts.sort == Sort::Word;
  const Slot usual = field.slot(data_of(is_word ? m_kind : sample));
  added.option = std::visit(Add<Option>{m_app, added, field}, usual);
  const bool is_in_all = [&] {
    for (size_t f = 0; f < m_table.forms.size(); ++f)
      if (m_op == m_table.forms[f].op && !field.is_in(f)) return false;
    return true;
  }();
  if (added.option && field.required && is_in_all) added.option->required();
}

const OperationOptions::Option* OperationOptions::find(const std::string& key) const {
  for (const auto& option : m_options)
    if (key == option->field->key) return option.get();
  return nullptr;
}

size_t OperationOptions::form() const {
  const auto given = [&](const char* key) {
    const Option* const option = find(key);
    return option && option->is_given();
  };
  const auto word = [&](const char* key) { return find(key)->texts[0]; };
  const auto form = m_table.chosen(m_op, given, word);
  if (!form) bad_input("%1: %2", m_app.get_name(), in_options(m_table.choice, m_table));
  return *form;
}

// Words that chose the form: "--to", "--about normal".
std::string OperationOptions::way(size_t form) const {
  for (const Form& other : m_table.forms) {
    if (other.words.empty()) continue;
    const Option& word = *find(other.marks[0]);
    const std::string usual = word.field->accepts.words[0];
    return name_of(other.marks[0]) + " " + (word.texts.empty() ? usual : word.texts[0]);
  }
  for (const char* const mark : m_table.forms[form].marks)
    if (find(mark)->is_given()) return name_of(mark);
  return m_app.get_name();
}

// Options of other forms, and those of this one that are missing.
void OperationOptions::refuse_others(size_t form) const {
  std::string accepted;
  for (const auto& option : m_options)
    if (option->field->is_in(form))
      accepted += (accepted.empty() ? "" : ", ") + name_of(option->field->key);
  for (const auto& option : m_options) {
    const Field& field = *option->field;
    const std::string name = name_of(field.key);
    if (option->is_given() && !field.is_in(form))
      bad_input("%1 is not accepted with %2; accepted: %3", name, way(form), accepted);
    if (option->is_given() || !field.required || !field.is_in(form)) continue;
    if (field.accepts.sort == Sort::Material)
      bad_input(
          "%1: --material is missing; accepted: --material NAME, --friction, --density, "
          "--restitution",
          m_app.get_name());
    bad_input("%1: %2 is missing with %3", m_app.get_name(), name, way(form));
  }
}

Operation OperationOptions::operation(Operation operation) const {
  const size_t form = this->form();
  refuse_others(form);
  if (m_table.forms[form].begin) m_table.forms[form].begin(data_of(operation));
  for (const auto& option : m_options)
    if (option->is_given())
      std::visit(Set<Option>{*option}, option->field->slot(data_of(operation)));
  if (auto found = find_invalid_argument(operation)) {
    found->key = name_of(found->key.c_str());
    bad_input(in_words(*found));
  }
  return operation;
}

void check_objects(const Operation& operation, const Scene& scene, const std::string& file) {
  const auto check = [&](const std::string& name) {
    if (!scene.find(name)) bad_file(file, sentence_of(unknown_object(scene, name)));
  };
  if (!std::holds_alternative<DrapeOperation>(operation) &&
      !std::holds_alternative<RepairOperation>(operation))
    check(object_name(operation));
  const OperationTable& table = table_of(operation);
  void* const data = const_cast<void*>(data_of(operation));  // slots are only read here
  for (const Field& field : table.fields) {
    if (!field.is_in(table.form_of(data))) continue;
    const Slot slot = field.slot(data);
    const auto* const name = std::get_if<std::string*>(&slot);
    if (name && field.accepts.sort == Sort::Support && **name != kFloorName) check(**name);
    if (const auto* const names = std::get_if<std::vector<std::string>*>(&slot))
      for (const std::string& one : **names) check(one);
  }
}

}  // namespace trivet::apps
