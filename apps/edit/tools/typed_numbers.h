// Numbers typed during a drag: "0.3", "-45", Tab for the next axis.
#pragma once

#include <string>
#include <vector>

namespace trivet::edit {

/// "12.5": six decimals at most, without zeros at the end.
std::string plain_number(double value);

class TypedNumbers {
 public:
  TypedNumbers() = default;  // takes nothing
  /// @param axes  names of the numbers; one of no name for a single number. @param first  is typed
  ///   first. @param unit  of all, with its space: " m", "°".
  TypedNumbers(std::vector<std::string> axes, size_t first, std::string unit);

  /// @return whether it belongs to numbers: digits, a point or comma, a minus, which turns the
  /// sign.
  static bool is_part(char c);
  void type(char c);
  /// Takes back the last character.
  void erase();
  void next_axis();

  bool takes_numbers() const { return !m_axes.empty(); }
  bool empty() const;  // nothing is typed
  /// One per axis; 0 where nothing is typed.
  std::vector<double> values() const;
  /// "x 0.3 m  [y] -0.1 m  z 0 m", the axis that is typed in brackets.
  std::string text() const;

 private:
  std::vector<std::string> m_axes, m_texts;
  size_t m_current = 0;
  std::string m_unit;
};

}  // namespace trivet::edit
