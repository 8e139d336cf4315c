#include "apps/demo/shapes/models.h"

#include <utility>

#include "core/base/error.h"

namespace trivet::shapes {
namespace {

using Maker = Model (*)();

constexpr std::pair<const char*, Maker> kMakers[] = {
    {"saucer", make_saucer},
    {"plate", make_plate},
    {"cup", make_cup},
    {"glass", make_glass},
    {"bowl", make_bowl},
    {"egg_cup", make_egg_cup},
    {"teapot", make_teapot},
    {"jug", make_jug},
    {"spoon", make_spoon},
    {"knife", make_knife},
    {"apple", make_apple},
    {"banana", make_banana},
    {"egg", make_egg},
    {"toast", make_toast},
    {"loaf", make_loaf},
    {"table", make_table},
    {"bare_table", make_bare_table},
    {"pegs", make_pegs},
    {"desk", make_desk},
    {"bookcase", make_bookcase},
    {"chair", make_chair},
    {"monitor", make_monitor},
    {"keyboard", make_keyboard},
    {"mouse", make_mouse},
    {"telephone", make_telephone},
    {"lamp", make_lamp},
    {"book_red", make_book_red},
    {"book_blue", make_book_blue},
    {"book_green", make_book_green},
    {"book_yellow", make_book_yellow},
    {"binder", make_binder},
    {"letter", make_letter},
    {"report", make_report},
    {"paper_ball", make_paper_ball},
    {"mug", make_mug},
    {"pencil", make_pencil},
    {"pen", make_pen},
    {"waste_basket", make_waste_basket},
    {"plant", make_plant},
    {"wall", make_wall},
    {"shop_shelf", make_shop_shelf},
    {"can_red", make_can_red},
    {"can_green", make_can_green},
    {"tin", make_tin},
    {"carton", make_carton},
    {"cereal", make_cereal},
    {"soap", make_soap},
    {"jar", make_jar},
    {"bottle", make_bottle},
    {"workbench", make_workbench},
    {"parts_bin", make_parts_bin},
    {"bolt", make_bolt},
    {"nut", make_nut},
    {"bracket", make_bracket},
    {"hammer", make_hammer},
    {"screwdriver", make_screwdriver},
    {"toolbox", make_toolbox},
    {"kitchen_unit", make_kitchen_unit},
    {"cutlery_drawer", make_cutlery_drawer},
    {"drawer_shallow", make_drawer_shallow},
    {"drawer_deep", make_drawer_deep},
    {"door_left", make_door_left},
    {"door_right", make_door_right},
    {"chopping_board", make_chopping_board},
};

}  // namespace

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : kMakers) names.emplace_back(name);
  return names;
}

Model make_model(const std::string& name) {
  std::string accepted;
  for (const auto& [known, make] : kMakers) {
    if (name == known) return make();
    accepted += std::string(accepted.empty() ? "" : ", ") + known;
  }
  throw Error(Error::Kind::BadInput, "no model '%1'; there are %2", name, accepted);
}

}  // namespace trivet::shapes
