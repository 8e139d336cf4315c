// Arrangements of the editor: wishes, previews that change nothing, one step, conflicts, files.
#include <atomic>
#include <fstream>
#include <sstream>

#include "apps/edit_document/scene_checks.h"
#include "apps/edit_document/testing.h"
#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/arrange/arrange.h"
#include "ops/files/arrange/problem.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::edit::test {
namespace {

/// A table, and three boxes that are not placed yet.
class Layouts : public testing::Test {
 protected:
  explicit Layouts(BackendOptions detection = {})
      : document(folder.file("recovery"), std::move(detection)) {
    write_boxes(folder.file("table.obj"), {{{-0.5, -0.4, 0}, {0.5, 0.4, 0.7}}});
    write_boxes(folder.file("box.obj"), {{{-0.05, -0.04, 0}, {0.05, 0.04, 0.1}}});
    document.import(folder.file("table.obj"), "table", true);
    for (const char* name : {"jug", "cup", "pot"}) document.import(folder.file("box.obj"), name);
    for (const char* name : {"jug", "cup", "pot"}) wish("on", name, "table");
    wish("right_of", "cup", "jug", 0.02, 0.1);
  }

  void wish(const std::string& is, const std::string& a, const std::string& b, double lower = 0,
            double upper = 0.1, std::optional<double> weight = {}) {
    NewWish wish;
    while (wish_kinds().at(wish.kind).is != is) ++wish.kind;
    wish.a = a, wish.b = b, wish.lower = lower, wish.upper = upper, wish.weight = weight;
    document->set_wishes(document->wishes().with(wish));
  }

  bool seek(std::uint64_t seed, bool selected_only = false) {
    EXPECT_TRUE(document->request_layout(seed, selected_only));
    EXPECT_TRUE(document->wait_until_idle());
    return document->layout() && document->layout()->ok;
  }

  bool accept() { return document.done(document->accept_layout()); }
  Vec3 at(const std::string& name) { return document.object(name).pose.translation; }
  // Metres along the jug's right, as one who stands before it sees it.
  double right_of_jug(const std::string& name) {
    return (at(name) - at("jug")).dot(document.object("jug").pose.rotation.matrix().col(0));
  }

  TemporaryFolder folder;
  Recorder document;
};

/// Counts the queries of z-lists in software, made on request for the GPU of each thread.
struct CountedGpu {
  class Stage : public CandidateFinder {
   public:
    explicit Stage(std::atomic<int>& num) : m_num(num) {}
    std::string name() const override { return "counted"; }
    CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
      ++m_num;
      return m_zlists.find_candidates(query, horizon);
    }

   private:
    std::atomic<int>& m_num;
    SoftwareZLists m_zlists;
  };

  std::atomic<int> num_made = 0, num_asked = 0;
  BackendOptions options() {
    BackendOptions out;
    out.backend = Backend::Gpu;
    out.make_gpu_stage = [this](const GpuNotes&) {
      ++num_made;
      return std::make_unique<Stage>(num_asked);
    };
    return out;
  }
};

class LayoutsByGpu : public CountedGpu, public Layouts {
 protected:
  LayoutsByGpu() : Layouts(options()) {}
};

/// The thread of arrangements has a detector of its own, as was chosen, and finds the same bits.
TEST_F(LayoutsByGpu, AskTheChosenDetector) {
  ASSERT_TRUE(document->wait_until_idle());
  const int made = num_made, asked = num_asked;
  ASSERT_TRUE(seek(1)) << document.last_text();
  EXPECT_EQ(num_made, made + 1);
  EXPECT_GT(num_asked, asked + 32);  // of the self-test
  const std::vector<Ghost::Member> members = document->layout()->members;
  BackendOptions bvh;
  bvh.backend = Backend::Bvh;
  document->choose_detection(bvh);
  ASSERT_TRUE(document->wait_until_idle());
  const int before = num_asked;
  ASSERT_TRUE(seek(1)) << document.last_text();
  EXPECT_EQ(num_asked, before);
  ASSERT_EQ(document->layout()->members.size(), members.size());
  for (size_t i = 0; i < members.size(); ++i) {
    const Pose &a = members[i].pose, &b = document->layout()->members[i].pose;
    EXPECT_EQ(a.translation, b.translation);
    EXPECT_EQ(a.rotation.matrix(), b.rotation.matrix());
  }
}

TEST_F(Layouts, PreviewChangesNothingAndAcceptingIsOneStep) {
  const std::uint64_t before = fingerprint(*document->snapshot());
  const size_t steps = document->history().num_done;
  ASSERT_TRUE(seek(1)) << document.last_text();
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
  const std::vector<Ghost::Member> members = document->layout()->members;
  ASSERT_EQ(members.size(), 3U);
  ASSERT_TRUE(accept()) << document.last_text();
  EXPECT_EQ(document->layout(), nullptr);
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  for (const Ghost::Member& member : members)  // to the bit as it was shown
    EXPECT_EQ(document->snapshot()->find(member.id)->object->pose.translation,
              member.pose.translation);
  EXPECT_GT(right_of_jug("cup"), 0.1);
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
}

TEST_F(Layouts, EverySeedIsAnotherSolution) {
  ASSERT_TRUE(seek(1));
  const Vec3 first = document->layout()->members.front().pose.translation;
  ASSERT_TRUE(seek(2));
  EXPECT_GT((document->layout()->members.front().pose.translation - first).norm(), 1e-3);
  EXPECT_EQ(document->layout()->seed, 2U);
  ASSERT_TRUE(seek(1));
  EXPECT_EQ(document->layout()->members.front().pose.translation, first);
  document->clear_layout();
  EXPECT_EQ(document->layout(), nullptr);
}

TEST_F(Layouts, SelectedAloneLeaveTheOthers) {
  ASSERT_TRUE(seek(1));
  ASSERT_TRUE(accept());
  const Vec3 jug = at("jug"), pot = at("pot"), cup = at("cup");
  document->select_only(document.id("cup"));
  ASSERT_TRUE(seek(7, true));
  ASSERT_EQ(document->layout()->members.size(), 1U);
  ASSERT_TRUE(accept());
  EXPECT_EQ(at("jug"), jug);
  EXPECT_EQ(at("pot"), pot);
  EXPECT_NE(at("cup"), cup);
  EXPECT_GT(right_of_jug("cup"), 0.1);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

// Without a wish about what carries them, things stay on what carries them now.
TEST_F(Layouts, ThingsWithoutWishesStayOnTheirSupport) {
  ASSERT_TRUE(seek(1));
  ASSERT_TRUE(accept());
  document->set_wishes({});
  document->select_only(document.id("pot"));
  ASSERT_TRUE(seek(3, true)) << document.last_text();
  ASSERT_TRUE(accept());
  EXPECT_NEAR(at("pot").z(), 0.7, 1e-3);
}

TEST_F(Layouts, ConflictNamesWishesAndTheCheapest) {
  wish("left_of", "cup", "jug", 0.02, 0.1);
  const std::uint64_t before = fingerprint(*document->snapshot());
  EXPECT_FALSE(seek(1));
  const auto layout = document->layout();
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->entries, (std::set<size_t>{3, 4}));
  ASSERT_TRUE(layout->cheapest);
  EXPECT_TRUE(layout->entries.count(*layout->cheapest));
  ASSERT_FALSE(document.messages().empty());
  EXPECT_EQ(document.messages().back().kind, Message::Kind::Refused);
  EXPECT_EQ(document.messages().back().objects.size(), 2U);
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
  document->set_wishes(document->wishes().without({*layout->cheapest}));
  EXPECT_TRUE(seek(1)) << document.last_text();
}

TEST_F(Layouts, WishesAreKeptWithTheScene) {
  ASSERT_TRUE(seek(1));
  ASSERT_TRUE(accept());
  wish("near", "pot", "jug", 0, 0.3, 2.0);
  EXPECT_TRUE(document->is_modified());
  ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb"))));
  EXPECT_FALSE(document->is_modified());
  const std::vector<Wish> before = document->wishes().list();
  ASSERT_TRUE(document.done(document->new_scene()));
  EXPECT_TRUE(document->wishes().empty());
  ASSERT_TRUE(document.done(document->open(folder.file("scene.glb"))));
  ASSERT_EQ(document->wishes().list().size(), 5U);
  for (size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(document->wishes().list()[i].text, before[i].text);
  EXPECT_EQ(document->wishes().list().back().weight, 2.0);
  EXPECT_FALSE(document->is_modified());
}

TEST_F(Layouts, SavesAProblemThatTheProgramArranges) {
  ASSERT_TRUE(document.done(document->save_problem(folder.file("problem.json"))));
  const Problem problem = read_problem(folder.file("problem.json"));
  EXPECT_EQ(problem.arrangement.things.size(), 3U);
  EXPECT_EQ(problem.arrangement.relations.size(), 4U);
  document->set_wishes({});
  document->load_wishes(folder.file("problem.json"));
  EXPECT_EQ(document->wishes().list().size(), 4U);
  std::ofstream(folder.file("bad.json")) << R"({"relations": [{"is": "abbove"}]})";
  EXPECT_THROW(document->load_wishes(folder.file("bad.json")), Error);
  EXPECT_THROW(document->load_wishes(folder.file("none.json")), Error);
  EXPECT_EQ(document->wishes().list().size(), 4U);
}

TEST_F(Layouts, AnotherSceneEndsTheSearch) {
  ASSERT_TRUE(document->request_layout(1, false));
  EXPECT_TRUE(document->is_seeking_layout());
  ASSERT_TRUE(document.done(document->new_scene()));
  EXPECT_TRUE(document->wait_until_idle());
  EXPECT_FALSE(document->is_seeking_layout());
  EXPECT_EQ(document->layout(), nullptr);
  EXPECT_FALSE(document->request_layout(1, false));  // there is nothing to arrange
}

TEST_F(Layouts, StepEndsTheSearch) {
  ASSERT_TRUE(document->request_layout(1, false));
  ASSERT_TRUE(document.done(document->perform(LockOperation{"pot", true})));
  EXPECT_FALSE(document->is_seeking_layout());
  EXPECT_EQ(document->layout(), nullptr);
}

TEST_F(Layouts, RefusesWeightsThatCannotBe) {
  const std::string before = document->wishes().json();
  EXPECT_FALSE(document->wishes().list()[0].may_be_soft);
  EXPECT_TRUE(document->wishes().list()[3].may_be_soft);
  const std::pair<size_t, double> bad[] = {{0, 1.0}, {3, 2e6}, {3, -1.0}, {3, kInfinity}};
  for (const auto& [entry, weight] : bad) {
    document.forget();
    document->set_wishes(document->wishes().weighted(entry, weight));
    EXPECT_EQ(document->wishes().json(), before) << entry << " " << weight;
    ASSERT_EQ(document.messages().size(), 1U) << entry << " " << weight;
    EXPECT_EQ(document.messages().back().kind, Message::Kind::Refused);
    EXPECT_NE(document.last_text().find("accepted"), std::string::npos) << document.last_text();
  }
  document->set_wishes(document->wishes().weighted(3, kMostWeight));
  EXPECT_EQ(document->wishes().list()[3].weight, kMostWeight);
}

TEST_F(Layouts, RefusesFilesThatAreNoProblems) {
  const std::string before = document->wishes().json();
  const std::string deep(100'000, '[');
  for (const std::string& text :
       {std::string(R"({"arrange": []})"), std::string(R"({"arrange": 7, "objects": []})"),
        std::string(R"({"arrange": {"fronts": "x"}, "objects": [{"name": "cup", "front": "x"}]})"),
        std::string(R"({"arrange": {"zones": []}, "objects": [{"name": "cup", "zones": []}]})"),
        std::string(R"({"arrange": {}, "objects": 7})"),
        std::string(R"({"arrange": {}, "objects": [{"name": "cup", "front": 7}]})"),
        std::string("[]"), std::string("no JSON"), deep}) {
    std::ofstream(folder.file("bad.json")) << text;
    EXPECT_THROW(document->load_wishes(folder.file("bad.json")), Error) << text.substr(0, 100);
    EXPECT_EQ(document->wishes().json(), before);
  }
  std::ofstream(folder.file("good.json"))
      << R"({"arrange": {"relations": []}, "objects": [{"name": "cup", "front": "-x"}]})";
  document->load_wishes(folder.file("good.json"));
  EXPECT_NE(document->wishes().json().find(R"("fronts":{"cup":"-x"})"), std::string::npos);
}

TEST_F(Layouts, KeepsTheWishesOfAFileThatIsOpening) {
  const std::string file = folder.file("scene.glb");
  ASSERT_TRUE(document.done(document->save_as(file)));
  const Document::Job opening = document->open(file);
  wish("near", "pot", "jug", 0, 0.3);  // about the scene that is still shown
  ASSERT_TRUE(document.done(opening)) << document.last_text();
  EXPECT_EQ(document->wishes().list().size(), 4U);
  EXPECT_FALSE(document->is_modified());
}

TEST_F(Layouts, IsAcceptedOnlyForTheSceneThatItWasFoundFor) {
  ASSERT_TRUE(seek(1));
  const size_t steps = document->history().num_done;
  document->perform(MaterialOperation{"table", {"", 0.3, 700, 0.1}});
  EXPECT_FALSE(accept());
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_NE(document.last_text().find("changed"), std::string::npos) << document.last_text();
  ASSERT_TRUE(seek(1));
  EXPECT_TRUE(accept()) << document.last_text();
}

TEST_F(Layouts, SelectedMemberOfAGroupTakesTheOthers) {
  ASSERT_TRUE(seek(1));
  ASSERT_TRUE(accept());
  for (const char* name : {"jug", "cup"})
    ASSERT_TRUE(document.done(document->perform(GroupOperation{name, "set"})));
  document->select_only(document.id("cup"));
  ASSERT_TRUE(seek(7, true)) << document.last_text();
  EXPECT_EQ(document->layout()->members.size(), 2U);
  ASSERT_TRUE(accept()) << document.last_text();
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

// Without a wish, a plank over the gap between two benches stays on them.
TEST_F(Layouts, BridgeStaysOnOneOfItsSupports) {
  write_boxes(folder.file("bench.obj"), {{{-0.2, -0.2, 0}, {0.2, 0.2, 0.2}}});
  write_boxes(folder.file("plank.obj"), {{{-0.1, -0.03, 0}, {0.1, 0.03, 0.02}}});
  const auto put = [&](const char* model, const char* name, const Vec3& to) {
    document.import(folder.file(model), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = to;
    ASSERT_TRUE(document.done(document->perform(operation))) << document.last_text();
  };
  put("bench.obj", "left", Vec3(1.795, 0, 0.01));
  put("bench.obj", "right", Vec3(2.205, 0, 0.01));
  put("plank.obj", "plank", Vec3(2, 0, 0.25));
  ASSERT_EQ(document.object("plank").contacts.size(), 2U);
  document->set_wishes({});
  document->select_only(document.id("plank"));
  ASSERT_TRUE(seek(3, true)) << document.last_text();
  ASSERT_TRUE(accept());
  EXPECT_NEAR(at("plank").z(), 0.2, 1e-3);
}

TEST_F(Layouts, FollowObjectsThatAreRenamed) {
  ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb"))));
  const std::string before = document->wishes().json();
  ASSERT_TRUE(document.done(document->perform(RenameOperation{"cup", "mug"})));
  EXPECT_EQ(document->wishes().list()[3].a, std::vector<std::string>{"mug"});
  EXPECT_TRUE(seek(1)) << document.last_text();
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document->wishes().json(), before);
  EXPECT_FALSE(document->is_modified());
  ASSERT_TRUE(document.done(document->redo()));
  EXPECT_EQ(document->wishes().list()[1].a, std::vector<std::string>{"mug"});
}

}  // namespace
}  // namespace trivet::edit::test
