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

/// Of a symbol: 0.01 of "cm"; 1 of one that is unknown.
double metres_of(const QString& symbol);

}  // namespace trivet::edit
