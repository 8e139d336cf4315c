// The layouts by name; use make_demo.
#pragma once

#include "apps/demo/demo.h"

namespace trivet {

DemoLayout make_spoon_saucer();
DemoLayout make_breakfast();
DemoLayout make_office1();
DemoLayout make_office2();
DemoLayout make_tablecloth();
DemoLayout make_desk_demo();
DemoLayout make_towel();
DemoLayout make_kitchen();

}  // namespace trivet
