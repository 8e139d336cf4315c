// Units of length that files of models come in.
#pragma once

#include <QString>
#include <vector>

namespace trivet::edit {

struct LengthUnit {
  QString name;  // for people, translated: "centimetres"
  double metres;
};
std::vector<LengthUnit> length_units();

}  // namespace trivet::edit
