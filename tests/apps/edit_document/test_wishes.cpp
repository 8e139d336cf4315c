// Wishes as text, and the thread that looks for arrangements.
#include "apps/edit/document/arrange_worker.h"
#include "apps/edit_document/testing.h"
#include "core/base/error.h"
#include "ops/files/arrange/section.h"

namespace trivet::edit::test {
namespace {

TEST(Wishes, AreReadAsTheyAre) {
  const Wishes wishes(R"({"seed": 5, "relations": [
    {"is": "row", "of": ["book_*"], "on": "shelf"},
    {"is": "right_of", "a": "cup", "b": "jug", "gap": [0.01, 0.03], "weight": 2},
    {"is": "keep", "a": "*", "distance": 0.01}]})");
  ASSERT_EQ(wishes.list().size(), 3U);
  EXPECT_EQ(wishes.seed(), 5U);
  EXPECT_EQ(wishes.list()[1].text, "\"cup\" right of \"jug\", 1 to 3 cm");
  EXPECT_TRUE(wishes.is_about(0, "book_7"));
  EXPECT_FALSE(wishes.is_about(1, "book_7"));
  EXPECT_FALSE(wishes.list()[0].may_be_soft);
  EXPECT_TRUE(wishes.list()[1].may_be_soft);
  EXPECT_FALSE(wishes.list()[2].may_be_soft);
  EXPECT_EQ(wishes.weighted(1, std::nullopt).list()[1].weight, std::nullopt);
  EXPECT_THROW(Wishes("[1]"), Error);
}

// A pattern counts where all its objects are among the things.
TEST(Wishes, PartHasThePatternsOfItsThingsAlone) {
  const Wishes wishes(R"({"relations": [
    {"is": "row", "of": ["book_*"], "on": "shelf"},
    {"is": "near", "a": "cup", "b": "book_1", "distance": 0.3},
    {"is": "row", "of": ["book_1", "gone"], "on": "shelf"},
    {"is": "keep", "a": "*", "distance": 0.01}]})");
  Wishes::Scope scope{{"book_1"}, {"shelf", "cup", "book_1", "book_2"}, {{"book_1", "shelf"}}};
  const Wishes::Part one = wishes.part(scope, 9);
  EXPECT_EQ(one.entries, (std::vector<size_t>{1, 3, 4})) << one.json;
  EXPECT_EQ(Wishes(one.json).seed(), 9U);
  EXPECT_EQ(Wishes(one.json).list().back().text, "\"book_1\" on \"shelf\"");
  scope.things.insert("book_2");
  EXPECT_EQ(wishes.part(scope, 9).entries, (std::vector<size_t>{0, 1, 3}));
}

TEST(Wishes, AreRenamedWhereverTheyNameAnObject) {
  const std::string text = R"({"things": [{"object": "on", "yaw": "any"}, {"objects": "cup*"}],)"
                           R"("relations": [{"is": "on", "a": "cup", "b": "on"},)"
                           R"({"is": "symmetric", "a": "cup", "b": "jug", "about": "on"},)"
                           R"({"is": "row", "of": ["cup", "jug"], "on": "on", "align": "left"},)"
                           R"({"is": "facings", "of": [{"things": "cup"}], "on": "on"},)"
                           R"({"is": "keep", "a": ["cup", "x*"], "distance": 1,)"
                           R"("except": [["cup", "jug"]]}],)"
                           R"("fronts": {"cup": "x", "x*": "y"},)"
                           R"("zones": {"on": [{"name": "cup", "box": [[0, 0, 0], [1, 1, 1]]}]}})";
  const std::string renamed = R"({"things":[{"object":"top","yaw":"any"},{"objects":"cup*"}],)"
                              R"("relations":[{"is":"on","a":"mug","b":"top"},)"
                              R"({"is":"symmetric","a":"mug","b":"jug","about":"top"},)"
                              R"({"is":"row","of":["mug","jug"],"on":"top","align":"left"},)"
                              R"({"is":"facings","of":[{"things":"mug"}],"on":"top"},)"
                              R"({"is":"keep","a":["mug","x*"],"distance":1,)"
                              R"("except":[["mug","jug"]]}],)"
                              R"("fronts":{"mug":"x","x*":"y"},)"
                              R"("zones":{"top":[{"name":"cup","box":[[0,0,0],[1,1,1]]}]}})";
  arrange_operation(text);  // it is one
  EXPECT_EQ(Wishes(text).renamed({{"cup", "mug"}, {"on", "top"}}).json(), renamed);
  // Both at once: two names that change places.
  const Wishes swapped(R"({"relations":[{"is":"on","a":"cup","b":"jug"}]})");
  EXPECT_EQ(swapped.renamed({{"cup", "jug"}, {"jug", "cup"}}).json(),
            R"({"relations":[{"is":"on","a":"jug","b":"cup"}]})");
  EXPECT_EQ(Wishes().renamed({{"cup", "mug"}}).json(), "");
}

// A request waits for the document's thread: Stop may come before it.
TEST(ArrangeWorker, ForgetsRequestsThatWereCancelledBefore) {
  std::atomic<int> num_found = 0;
  ArrangeWorker::Listener listener;
  listener.found = [&](std::uint64_t, const LayoutGhost&) { ++num_found; };
  listener.progressed = [](std::uint64_t, const std::string&, size_t, size_t) {};
  ArrangeWorker worker({}, listener);
  const auto request = [&](std::uint64_t number) {
    ArrangeWorker::Request out;
    out.number = number;
    out.part.json = R"({"things": [], "relations": []})";
    out.scene = std::make_unique<Scene>();
    worker.request(std::move(out));
    while (!worker.is_idle()) std::this_thread::yield();
  };
  worker.cancel(5);
  for (const std::uint64_t number : {4U, 5U}) request(number);
  EXPECT_EQ(num_found, 0);
  request(6);
  EXPECT_EQ(num_found, 1);
}

}  // namespace
}  // namespace trivet::edit::test
