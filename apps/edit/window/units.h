// Units of length that files of models come in.
#pragma once

#include <QString>
#include <vector>

namespace trivet::edit {

struct LengthUnit {
  QString name;  // for people, translated: "centimetres"
  QString symbol;
  double metres;
};
std::vector<LengthUnit> length_units();

/// Length of a unit by its symbol: 0.01 for "cm"; 1 for an unknown one.
double metres_of(const QString& symbol);

}  // namespace trivet::edit
