// A bookcase with books in rows, and a shelf of a shop.
#include "apps/demo/problem_writer.h"

namespace trivet {
namespace {

using Json = ProblemWriter::Json;

// Things of one model, side by side and behind each other.
struct Product {
  const char* model;
  int count, wide;
  double scale = 1;
};

// A board full of products.
void stock(ProblemWriter& w, int level, const std::vector<Product>& products) {
  Json blocks = Json::array();
  for (const Product& product : products) {
    Json things = Json::array();
    for (int i = 0; i < product.count; ++i) {
      things.push_back(std::string(product.model) + "_" + std::to_string(level + 1) + "_" +
                       std::to_string(i + 1));
      w.add(things.back(), product.model, Json::object(), product.scale);
    }
    blocks.push_back({{"things", things}, {"wide", product.wide}});
  }
  w.add_relation({{"is", "facings"},
                  {"of", blocks},
                  {"on", "shelf"},
                  {"level", level},
                  {"gap", 0.006},
                  {"align", "spread"},
                  {"inset", 0.015}});
}

}  // namespace

ArrangedDemo make_bookcase_demo() {
  ProblemWriter w("bookcase");
  w.look({Vec3(0.80, -2.75, 1.55), Vec3(0.05, 0, 0.72), 36});
  w.fix("bookcase", "bookcase");
  constexpr const char* kBooks[] = {"book_red", "book_blue", "book_green", "book_yellow"};
  constexpr int kCounts[] = {15, 17, 13};
  int number = 0;
  for (int board = 0; board < 3; ++board) {
    Json books = Json::array();
    for (int i = 0; i < kCounts[board]; ++i, ++number) {
      const std::string name = "book_" + std::to_string(board + 1) + "_" + std::to_string(i + 1);
      // Sizes repeat after 35 books only.
      w.add(name, kBooks[(number * 3 + number / 7) % 4], Json::object(), 0.9 + 0.05 * (number % 5));
      books.push_back(name);
    }
    constexpr const char* kAligned[] = {"left", "spread", "right"};
    w.add_relation({{"is", "row"},
                    {"of", books},
                    {"on", "bookcase"},
                    {"level", board},
                    {"gap", 0.0008},
                    {"align", kAligned[board]},
                    {"across", "front"},
                    {"inset", 0.03},
                    {"order", "any"}});
  }
  w.add("mug", "mug");
  w.relate("on", "mug", "bookcase", {{"level", 2}});
  for (const char* name : {"plant", "telephone"}) {
    w.add(name, name);
    w.relate("on", name, "bookcase", {{"level", "top"}});
  }
  w.relate("same", "telephone", "bookcase");
  w.relate("right_of", "plant", "telephone", {{"gap", {0.03, 1}}, {"overlap", 0}});
  w.add("waste_basket", "waste_basket");
  w.relate("right_of", "waste_basket", "bookcase", {{"gap", {0.03, 0.15}}});
  return w.take();
}

// 121 products on five boards, a stack beside the shelf, and a basket.
ArrangedDemo make_market() {
  ProblemWriter w("market");
  w.look({Vec3(0.95, -3.05, 1.55), Vec3(0.04, 0, 0.80), 36});
  w.fix("shelf", "shop_shelf");
  stock(w, 0, {{"bottle", 12, 6}, {"carton", 10, 5}});
  stock(w, 1, {{"cereal", 6, 3}, {"jar", 12, 3}});
  stock(w, 2, {{"can_red", 15, 5}, {"can_green", 15, 5}});
  stock(w, 3, {{"tin", 15, 5}, {"soap", 12, 4}});
  stock(w, 4, {{"jar", 10, 5, 0.85}, {"bottle", 8, 4, 0.8}, {"tin", 6, 3, 0.9}});
  Json stack = Json::array();
  for (int i = 1; i <= 4; ++i) {
    w.add("cereal_stack_" + std::to_string(i), "cereal", {{"pose", 0}, {"yaw", {0, 90}}});
    stack.push_back("cereal_stack_" + std::to_string(i));
  }
  w.add_relation({{"is", "stack"}, {"of", stack}, {"on", "floor"}, {"tolerance", 0.02}});
  w.relate("right_of", "cereal_stack_1", "shelf", {{"gap", {0.05, 0.3}}});
  w.add("basket", "waste_basket");
  w.relate("left_of", "basket", "shelf", {{"gap", {0.05, 0.3}}});
  w.add("apple_1", "apple", {{"pose", "free"}});
  w.relate("in", "apple_1", "basket");
  return w.take();
}

}  // namespace trivet
