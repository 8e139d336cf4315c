#include "apps/trivet/zlist_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/trivet/list_output.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

using Json = nlohmann::ordered_json;

double mean_length(const CompleteZLists& lists) {
  const size_t covered = lists.num_covered();
  return covered > 0 ? static_cast<double>(lists.num_entries()) / static_cast<double>(covered) : 0;
}

size_t num_faces(const ZListsOf& what) {
  size_t out = 0;
  for (const Body& body : what.bodies) out += body.shape->mesh.triangles.size();
  return out;
}

// The line through the centre may miss the face and then has no depth.
Json centre_json(const Projection& view, const ZListItem& item) {
  return std::isnan(item.centre) ? Json(nullptr) : Json(view.depth(item.centre));
}

Json list_json(const ZListsOf& what, ImagePixel pixel) {
  const Projection& view = what.lists->projection();
  Json list = Json::array();
  for (const ZListItem& item : what.at(pixel.column, pixel.row))
    list.push_back({{"object", what.names[item.body]},
                    {"face", item.face},
                    {"depth", {view.depth(item.lower), view.depth(item.upper)}},
                    {"centre", centre_json(view, item)},
                    {"crossing", to_string(what.lists->crossing(item))}});
  return {{"column", pixel.column}, {"row", pixel.row}, {"list", std::move(list)}};
}

Json head_json(const ZListsOf& what) {
  const CompleteZLists& lists = *what.lists;
  const Projection& view = lists.projection();
  Json objects = Json::array();
  for (size_t i = 0; i < what.names.size(); ++i)
    objects.push_back({{"name", what.names[i]},
                       {"triangles", what.bodies[i].shape->mesh.triangles.size()},
                       {"solid", what.bodies[i].shape->mass.rule == MassRule::Volume}});
  return {{"direction", numbers_json(view.direction)},
          {"right", numbers_json(view.right)},
          {"up", numbers_json(view.up)},
          {"left", view.corner.x()},
          {"top", view.corner.y() + view.pixel * view.height},
          {"pixel_size", view.pixel},
          {"width", view.width},
          {"height", view.height},
          {"covered_pixels", lists.num_covered()},
          {"entries", lists.num_entries()},
          {"mean_list", mean_length(lists)},
          {"longest_list", lists.longest()},
          {"bytes", lists.num_bytes()},
          {"milliseconds", what.milliseconds},
          {"objects", std::move(objects)}};
}

std::string list_text(const ZListsOf& what, ImagePixel pixel) {
  const Projection& view = what.lists->projection();
  const double left = view.corner.x() + view.pixel * pixel.column;
  const double top = view.corner.y() + view.pixel * (view.height - pixel.row);
  const auto list = what.at(pixel.column, pixel.row);
  std::string out =
      formatted("pixel %d %d: %zu faces; right %.9g to %.9g m, up %.9g to %.9g m\n", pixel.column,
                pixel.row, list.size(), left, left + view.pixel, top - view.pixel, top);
  if (!list.empty())
    out += formatted("  %-13s %-13s %-13s %-9s %9s  %s\n", "depth from, m", "to", "at the centre",
                     "crossing", "face", "object");
  for (const ZListItem& item : list) {
    const std::string centre =
        std::isnan(item.centre) ? "-" : formatted("%.9g", view.depth(item.centre));
    out += formatted("  %-13.9g %-13.9g %-13s %-9s %9u  ", view.depth(item.lower),
                     view.depth(item.upper), centre.c_str(), to_string(what.lists->crossing(item)),
                     item.face);
    out += what.names[item.body] + "\n";
  }
  return out;
}

}  // namespace

std::string zlists_text(const ZListsOf& what, std::optional<ImagePixel> pixel) {
  const CompleteZLists& lists = *what.lists;
  const Projection& view = lists.projection();
  std::string out = formatted("z-lists of %zu object%s, %zu faces, along %g %g %g\n",
                              what.names.size(), what.names.size() == 1 ? "" : "s", num_faces(what),
                              view.direction.x(), view.direction.y(), view.direction.z());
  out += formatted("  image: %d x %d pixels of %.6g m; right is %g %g %g, up %g %g %g\n",
                   view.width, view.height, view.pixel, view.right.x(), view.right.y(),
                   view.right.z(), view.up.x(), view.up.y(), view.up.z());
  out += formatted(
      "  lists: %zu pixels covered, %.2f faces on average, %zu in the longest, %zu in all\n",
      lists.num_covered(), mean_length(lists), lists.longest(), lists.num_entries());
  out += formatted("  cost: %.1f MiB, %.1f ms\n",
                   static_cast<double>(lists.num_bytes()) / (1 << 20), what.milliseconds);
  return pixel ? out + list_text(what, *pixel) : out;
}

std::string zlists_json(const ZListsOf& what, std::optional<ImagePixel> pixel) {
  Json json = head_json(what);
  if (pixel) json["pixel"] = list_json(what, *pixel);
  return readable_json(json);
}

void write_zlists(const ZListsOf& what, const ByteSink& write) {
  JsonLines lines(write);
  Json head = head_json(what);
  head["entry"] = {"object, counted from 0", "face",    "depth from", "to",
                   "at the centre",          "crossing"};
  lines.add(head);
  const Projection& view = what.lists->projection();
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      Json list = Json::array();
      for (const ZListItem& item : what.at(column, row))
        list.push_back({item.body, item.face, view.depth(item.lower), view.depth(item.upper),
                        centre_json(view, item), to_string(what.lists->crossing(item))});
      if (list.empty()) continue;
      lines.add({{"pixel", {column, row}}, {"list", std::move(list)}});
    }
  lines.finish();
}

}  // namespace trivet::apps
