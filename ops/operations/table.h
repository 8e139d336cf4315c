// Arguments of operations as tables, one row each. They alone say what is accepted: checks
// (validate.h), JSON and its schema (ops/files/json), options of the command line and methods of
// Python are made of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/limits.h"
#include "core/base/sentence.h"
#include "core/motion/pose.h"
#include "core/scene/physics_material.h"
#include "ops/operations/move_options.h"

namespace trivet {

/// An argument that is not accepted, by its key in layouts.
struct InvalidArgument {
  std::string key, value;
  Sentence accepted;
  Sentence why = {};  // a sentence instead of the two before, for rules over several arguments
};

/// An enumerator, by its place among Accepts::words; -1: none.
struct WordSlot {
  void* value;
  int (*get)(const void* value);
  void (*set)(void* value, int word);
};

/// Where the value of an argument is, in one operation.
using Slot =
    std::variant<bool*, int*, std::uint64_t*, double*, std::optional<double>*, std::string*,
                 std::optional<std::string>*, std::vector<std::string>*, Vec2*, Vec3*,
                 std::optional<Vec2>*, std::optional<Vec3>*, std::vector<Vec2>*, std::vector<Vec3>*,
                 Rotation*, PhysicsMaterial*, std::optional<PhysicsMaterial>*, WordSlot>;

/// Values that an argument takes; whether it is one, one at most or a list says its Slot.
struct Accepts {
  enum class Sort {
    Flag,
    Number,       // from `lower` to `upper`, or the default
    Whole,        // the same without fractions
    Coordinates,  // each component from `lower` to `upper`; words[0]: what stands for none
    Direction,    // of any length but zero; components as above
    Rotation,     // of unit length in operations; JSON and others scale it
    Region,       // corners of a convex polygon, counter-clockwise
    Object,       // name of an object of the scene
    Support,      // the same, or "floor"
    NewName,      // any name but "floor"
    Text,
    Word,  // one of `words`
    Material,
  };
  Sort sort;
  double lower = 0, upper = 0;
  const char* unit = "";  // as people read it: "metres"
  std::array<const char*, 3> words{};
  std::optional<double> none = {};  // beyond the range: a default that stands for no number
};

using Sort = Accepts::Sort;
inline constexpr Accepts kFlag{Sort::Flag}, kText{Sort::Text}, kObjectName{Sort::Object},
    kSupportName{Sort::Support}, kNewName{Sort::NewName}, kMaterial{Sort::Material},
    kLength{Sort::Number, 0, kMaxLength, "metres"},
    kHeight{Sort::Number, -kMaxLength, kMaxLength, "metres"},
    kAngle{Sort::Number, -kMaxAngleDeg, kMaxAngleDeg, "degrees"},
    kPoint{Sort::Coordinates, -kMaxLength, kMaxLength, "metres"},
    kDirection{Sort::Direction, -kMaxDirectionComponent, kMaxDirectionComponent},
    kRotation{Sort::Rotation, -kMaxQuaternionComponent, kMaxQuaternionComponent},
    kRegion{Sort::Region, -kMaxLength, kMaxLength, "metres"},
    kSeed{Sort::Whole, 0, static_cast<double>(kMaxSeed)};

/// One argument.
struct Field {  // NOLINT(clang-analyzer-core.uninitialized.Assign): a base that is an aggregate
  const char* key;
  Accepts accepts;
  const char* help;
  const char* off = "";     // the same for a switch that is on by default, when it is off
  unsigned forms = ~0u;     // bits: the forms of the table that have it
  bool required = false;    // in these
  bool is_written = false;  // in files, even where it has its default
  std::function<Slot(void* operation)> slot;

  bool is_in(size_t form) const { return (forms >> form & 1u) != 0; }
};

/// One way to state an operation: a subset of the fields.
struct Form {
  const char* op;  // name in layouts, journals and programs
  const char* help;
  /// The form is chosen where one of these keys is given; the last one of a table needs none.
  std::vector<const char*> marks;
  std::vector<const char*> words;                    // only if marks[0] has one of these values
  std::function<bool(const void* operation)> holds;  // empty: for every operation
  std::function<void(void* operation)> begin;        // makes `holds` true; empty: nothing to do
};

/// All that is to be said of an operation's arguments.
struct OperationTable {
  std::vector<Form> forms;    // those whose marks come first are asked for first
  std::vector<Field> fields;  // in the order in which they are written
  const char* choice = "";    // what is missing where no form is chosen, in the words of layouts
  std::function<std::optional<InvalidArgument>(const void* operation)> rule;  // over several fields

  size_t form_of(const void* operation) const;
  const Field* find(std::string_view key) const;
  /// Keys of one form, "op" first. @param required  those, else the others.
  std::vector<const char*> keys(size_t form, bool required) const;
  /// The form that these arguments choose. @param given  is there one of this key?
  /// @param word  its value, if it is a word.
  /// @return nullopt: they choose none; see `choice`.
  std::optional<size_t> chosen(std::string_view op,
                               const std::function<bool(const char* key)>& given,
                               const std::function<std::string(const char* key)>& word) const;
};

/// "KEY: VALUE is not accepted; accepted: ..."
Sentence in_words(const InvalidArgument& found);

// Rows as the files of the operations write them.

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {
  using Value = T;
};

template <class V>
Slot slot_of(V& value) {
  if constexpr (std::is_enum_v<V>) {
    return WordSlot{&value,
                    [](const void* v) { return static_cast<int>(*static_cast<const V*>(v)); },
                    [](void* v, int word) { *static_cast<V*>(v) = static_cast<V>(word); }};
  } else if constexpr (std::is_constructible_v<Slot, V*>) {
    return &value;
  } else {
    using E = typename IsOptional<V>::Value;
    return WordSlot{&value,
                    [](const void* v) {
                      const auto& it = *static_cast<const V*>(v);
                      return it ? static_cast<int>(*it) : -1;
                    },
                    [](void* v, int word) { *static_cast<V*>(v) = static_cast<E>(word); }};
  }
}

/// A row of the table of `P`.
template <class P>
struct Row : Field {
  template <class B, class V>
  Row(const char* name, V B::*member, Accepts values, const char* what)
      : Field{name,  values,
              what,  "",
              ~0u,   false,
              false, [member](void* o) {
                return slot_of(static_cast<P*>(o)->*member); }} {}
  /// A member of a member, which is there in the forms of this row.
  template <class B, class O, class I, class V>
  Row(const char* name, O B::*outer, V I::*inner, Accepts values, const char* what)
      : Field{name, values, what, "", ~0u, false, false, [outer, inner](void* o) {
                auto& part = static_cast<P*>(o)->*outer;
                if constexpr (IsOptional<O>::value)
                  return slot_of((*part).*inner);
                else
                  return slot_of(part.*inner);
              }} {}

  Row in(std::initializer_list<unsigned> of) const {
    Row out = *this;
    out.forms = 0;
    for (const unsigned form : of) out.forms |= 1u << form;
    return out;
  }
  Row needed() const {
    Row out = *this;
    out.required = true;
    return out;
  }
  Row always_written() const {
    Row out = *this;
    out.is_written = true;
    return out;
  }
  Row otherwise(const char* what) const {
    Row out = *this;
    out.off = what;
    return out;
  }
};

template <class P>
struct FormRow {
  const char* op;
  const char* help;
  std::vector<const char*> marks = {}, words = {};
  bool (*holds)(const P&) = nullptr;
  void (*begin)(P&) = nullptr;
};

/// The table of `P`: these rows, the object before them, and what all moves have after them.
template <class P>
OperationTable make_table(std::initializer_list<FormRow<P>> forms, const std::vector<Row<P>>& rows,
                          std::optional<InvalidArgument> (*rule)(const P&) = nullptr,
                          const char* choice = "") {
  OperationTable out;
  for (const FormRow<P>& form : forms) {
    Form& added = out.forms.emplace_back(Form{form.op, form.help, form.marks, form.words, {}, {}});
    if (form.holds)
      added.holds = [holds = form.holds](const void* o) {
        return holds(*static_cast<const P*>(o));
      };
    if (form.begin) added.begin = [begin = form.begin](void* o) { begin(*static_cast<P*>(o)); };
  }
  if (rows.empty() || std::string_view(rows.front().key) != "object")
    out.fields.push_back(Row<P>("object", &P::object, kObjectName, "Name of the object").needed());
  out.fields.insert(out.fields.end(), rows.begin(), rows.end());
  if constexpr (std::is_base_of_v<JointMoveOptions, P>)
    out.fields.push_back(Row<P>("together", &P::together, kObjectName,
                                "Objects that move along, like those of its group; they are "
                                "released with it, the lowest first"));
  if constexpr (std::is_base_of_v<MoveOptions, P>)
    out.fields.push_back(Row<P>(
        "settle_left", &P::settle_left, kFlag,
        "Settle objects that lose their support, in order; otherwise they stay and are named"));
  if (rule) out.rule = [rule](const void* o) { return rule(*static_cast<const P*>(o)); };
  out.choice = choice;
  return out;
}

}  // namespace trivet
