// Arrangement problem as the editor lists it: the section "arrange" of a layout, entry by
// entry. Immutable: changes give another one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace trivet::edit {

/// Numbers that a kind of relation takes from the panel.
enum class WishNumbers {
  None,
  Gap,       // from ... to, metres
  Distance,  // to, metres
  Part,      // of the whole, 0 to 1
};

/// A relation of two objects that the panel offers.
struct WishKind {
  const char* is;     // as in "relations"
  const char* label;  // between the names of both: "right of"
  WishNumbers numbers = WishNumbers::None;
  bool may_be_soft = true;
};
const std::vector<WishKind>& wish_kinds();

/// Weights of soft wishes are from 0 to this, as in `trivet schema arrange`.
inline constexpr double kMostWeight = 1e6;

struct NewWish {
  size_t kind = 0;  // of wish_kinds()
  std::string a, b;
  double lower = 0, upper = 0.1;  // metres, as far as the kind has them
  double part = 0.5;
  std::optional<double> weight;  // soft; nullopt: hard
};

/// An entry of "relations".
struct Wish {
  std::string is;
  std::string text;               // "cup" right of "plate", 1 to 3 cm; translated
  std::vector<std::string> a, b;  // names or patterns of names, as it has them
  bool is_pattern = false;        // a row, a grid, ... of all its objects
  bool may_be_soft = false;
  std::optional<double> weight;
};

class Wishes {
 public:
  Wishes() = default;
  /// @throws Error (BadInput) unless it is a JSON object.
  explicit Wishes(const std::string& json);

  const std::string& json() const { return m_json; }  // empty: no wishes
  const std::vector<Wish>& list() const { return m_list; }
  bool empty() const { return m_list.empty(); }
  std::uint64_t seed() const;

  Wishes with(const NewWish& wish) const;
  Wishes without(const std::set<size_t>& entries) const;
  /// @param weight  nullopt: hard.
  Wishes weighted(size_t entry, std::optional<double> weight) const;
  /// True if an entry is about this object.
  bool is_about(size_t entry, const std::string& object) const;

  /// With other names for some objects; patterns stay. @param names  old, new.
  Wishes renamed(const std::map<std::string, std::string>& names) const;

  struct Scope {
    std::set<std::string> things;                   // to be arranged
    std::vector<std::string> names;                 // of all objects
    std::map<std::string, std::string> carried_by;  // now: an object, what carries it
  };
  struct Part {
    std::string json;
    std::vector<size_t> entries;  // place in list() of each relation; its size: it was added
  };
  /// The problem of some things alone, all others as they stand: with the entries that are about
  /// them, and, for those without one, the object that carries each of them now.
  Part part(const Scope& scope, std::uint64_t seed) const;

 private:
  std::string m_json;
  std::vector<Wish> m_list;
};

}  // namespace trivet::edit
