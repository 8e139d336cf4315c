#include "apps/edit/window/units.h"

#include <QCoreApplication>

namespace trivet::edit {

std::vector<LengthUnit> length_units() {
  return {{QCoreApplication::translate("units", "metres"), "m", 1},
          {QCoreApplication::translate("units", "centimetres"), "cm", 0.01},
          {QCoreApplication::translate("units", "millimetres"), "mm", 0.001},
          {QCoreApplication::translate("units", "inches"), "in", 0.0254},
          {QCoreApplication::translate("units", "feet"), "ft", 0.3048}};
}

double metres_of(const QString& symbol) {
  for (const LengthUnit& unit : length_units())
    if (unit.symbol == symbol) return unit.metres;
  return 1;
}

}  // namespace trivet::edit
