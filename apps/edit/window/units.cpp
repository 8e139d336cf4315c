#include "apps/edit/window/units.h"

#include <QCoreApplication>

namespace trivet::edit {

std::vector<LengthUnit> length_units() {
  return {{QCoreApplication::translate("units", "metres"), 1},
          {QCoreApplication::translate("units", "centimetres"), 0.01},
          {QCoreApplication::translate("units", "millimetres"), 0.001},
          {QCoreApplication::translate("units", "inches"), 0.0254},
          {QCoreApplication::translate("units", "feet"), 0.3048}};
}

}  // namespace trivet::edit
