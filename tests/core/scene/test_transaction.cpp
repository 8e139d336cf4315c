// All or nothing, nested, undone and redone.
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/scene/transaction.h"
#include "cube.h"
#include "random_changes.h"
#include "support/effort.h"
#include "support/same_scene.h"
#include "support/solids.h"

namespace trivet {
namespace {

using test::all_answers;
using test::cube;

Contact contact_at(double x) {
  Contact c;
  c.points = {{Vec3(x, 0, 0), Vec3::UnitZ(), 1e-6, ContactFeatures::VertexFace, 1, 2}};
  return c;
}

TEST(Transaction, OfNothingIsEmpty) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  Transaction transaction(scene);
  transaction.scene().at(a);
  EXPECT_TRUE(transaction.touched().empty());
  EXPECT_TRUE(transaction.commit().empty());
}

TEST(Transaction, HoldsWhatWasTouchedAndNothingElse) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  scene.add(cube("d"));
  Transaction first(scene);
  first.set_contacts(a, {{b, contact_at(1)}});
  first.commit();
  Transaction second(scene);
  second.set_contacts(a, {{c, contact_at(2)}});  // b loses a link, c gets one
  EXPECT_EQ(second.touched(), (std::vector{a, b, c}));
  EXPECT_EQ(second.commit().ids(), (std::vector{a, b, c}));
}

TEST(Transaction, UndoesAndRedoesPosesAndLinksToTheBit) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  Transaction first(scene);
  first.set_contacts(a, {{b, contact_at(1)}});
  first.commit();
  const Scene before = scene;
  Transaction second(scene);
  second.edit(a, [](Object& o) { o.pose.translation = Vec3(1, 2, 3), o.placed = true; });
  second.set_contacts(b, {{Support::floor(), contact_at(3)}, {a, contact_at(4)}});
  SceneChange change = second.commit();
  const Scene after = scene;
  for (int round = 0; round < 3; ++round) {
    scene.exchange(change);
    EXPECT_EQ(test::difference(scene, before), "");
    EXPECT_TRUE(scene.box().empty());
    scene.exchange(change);
    EXPECT_EQ(test::difference(scene, after), "");
    EXPECT_EQ(scene.near({Vec3(1, 2, 3), Vec3(1, 2, 3)}), (std::vector{a}));
  }
}

TEST(Transaction, BringsRemovedObjectsBackWithTheirIdsLinksAndOrder) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  Transaction first(scene);
  first.set_contacts(a, {{b, contact_at(1)}, {c, contact_at(2)}});
  first.commit();
  const Scene before = scene;
  Transaction second(scene);
  second.remove(a);
  const ObjectId d = second.add(cube("d"));  // in a's slot
  EXPECT_EQ(d.index, a.index);
  EXPECT_EQ(second.touched(), (std::vector{a, d, b, c}));
  SceneChange change = second.commit();
  scene.exchange(change);
  EXPECT_EQ(test::difference(scene, before), "");
  EXPECT_TRUE(scene.contains(a));
  EXPECT_FALSE(scene.contains(d));
  EXPECT_EQ(scene.ids(), (std::vector{a, b, c}));
  EXPECT_EQ(scene.at(b).contacts.size(), 1u);
  scene.exchange(change);
  EXPECT_TRUE(scene.contains(d));
  EXPECT_EQ(scene.at(d).name, "d");
  EXPECT_TRUE(scene.at(b).contacts.empty());
}

TEST(Transaction, NeverGivesAnIdOfAnUndoneObjectAgain) {
  Scene scene;
  ObjectId a;
  {
    Transaction transaction(scene);
    a = transaction.add(cube("a"));
  }
  EXPECT_FALSE(scene.contains(a));
  const ObjectId b = scene.add(cube("b"));
  EXPECT_EQ(b.index, a.index);
  EXPECT_NE(b, a);
  EXPECT_FALSE(scene.contains(a));
}

TEST(Transaction, RollsBackWhenAnEditThrows) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  const std::string before = all_answers(scene);
  const auto run = [&] {
    Transaction transaction(scene);
    transaction.add(cube("b"));
    transaction.edit(a, [](Object& o) {
      o.placed = true;
      throw std::runtime_error("half way");
    });
    transaction.commit();
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_EQ(all_answers(scene), before);
}

TEST(Transaction, FollowsAnEditThatThrewWhileItIsOpen) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  Transaction transaction(scene);
  try {
    transaction.edit(a, [](Object& o) {
      o.placed = true;
      throw std::runtime_error("half way");
    });
  } catch (const std::runtime_error&) {
    EXPECT_TRUE(scene.is_consistent());
  }
  transaction.commit();
  EXPECT_EQ(scene.near(scene.box()), (std::vector{a}));
}

TEST(Transaction, NestsAndTakesBackTheInnerOneAlone) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  const std::string at_first = all_answers(scene);
  Transaction outer(scene);
  outer.edit(a, [](Object& o) { o.placed = true; });
  const std::string outside = all_answers(scene);
  {
    Transaction inner(scene);
    inner.edit(a, [](Object& o) { o.pose.translation = Vec3::Ones(); });
    inner.add(cube("b"));
  }
  EXPECT_EQ(all_answers(scene), outside);
  {
    Transaction inner(scene);
    inner.add(cube("c"));
    EXPECT_TRUE(inner.commit().empty());  // the outer one has it
  }
  const std::string after = all_answers(scene);
  SceneChange change = outer.commit();
  EXPECT_EQ(all_answers(scene), after);
  scene.exchange(change);
  EXPECT_EQ(all_answers(scene), at_first);
}

TEST(Transaction, LeavesCopiesOfTheSceneAlone) {
  Scene scene;
  scene.add(cube("a"));
  Transaction transaction(scene);
  Scene copy = scene;
  copy.add(cube("b"));
  EXPECT_TRUE(transaction.commit().empty());
  EXPECT_EQ(copy.num_objects(), 2u);
  Scene other;
  other = copy;
  EXPECT_TRUE(other.is_consistent());
  EXPECT_EQ(all_answers(other), all_answers(copy));
}

// --- random sequences ------------------------------------------------------------------------

struct Counts {
  int committed = 0, rolled_back = 0, undone = 0;
};

// Changes with transactions in transactions, up to three deep.
void run_nested(Scene& scene, test::RandomChanges& changes, int depth, Counts& counts,
                std::vector<SceneChange>* undo_stack) {
  const std::string before = all_answers(scene);
  bool commits = true;
  {
    Transaction transaction(scene);
    for (int i = changes.random().integer(1, 4); i > 0; --i) {
      changes.apply(transaction);
      if (depth < 3 && changes.random().integer(0, 2) == 0)
        run_nested(scene, changes, depth + 1, counts, nullptr);
      ASSERT_EQ(test::unlike_brute_force(scene, changes.random()), "");
    }
    commits = changes.random().integer(0, 2) != 0;
    ++(commits ? counts.committed : counts.rolled_back);
    if (commits) {
      SceneChange change = transaction.commit();
      if (undo_stack) undo_stack->push_back(std::move(change));
    }
  }
  if (!commits) {
    ASSERT_EQ(all_answers(scene), before);
  }
  ASSERT_EQ(test::unlike_brute_force(scene, changes.random()), "");
}

// All the way back and forward again, through what the scene answered then.
void undo_and_redo_all(Scene& scene, std::vector<SceneChange>& done,
                       const std::vector<std::string>& answers, Counts& counts) {
  for (size_t i = done.size(); i-- > 0;) {
    scene.exchange(done[i]);
    ++counts.undone;
    ASSERT_EQ(all_answers(scene), answers[i]);
    ASSERT_TRUE(scene.is_consistent());
  }
  for (size_t i = 0; i < done.size(); ++i) {
    scene.exchange(done[i]);
    ASSERT_EQ(all_answers(scene), answers[i + 1]);
  }
}

TEST(Transaction, AnswersLikeBruteForceThroughRandomSequences) {
  Counts counts;
  const int num_seeds = test::with_effort(60);
  for (int seed = 0; seed < num_seeds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Scene scene;
    test::RandomChanges changes(seed);
    std::vector<SceneChange> done;
    std::vector<std::string> answers{all_answers(scene)};
    for (int step = 0; step < 20 && !HasFailure(); ++step) {
      run_nested(scene, changes, 1, counts, &done);
      if (done.size() == answers.size()) answers.push_back(all_answers(scene));
    }
    if (!HasFailure()) undo_and_redo_all(scene, done, answers, counts);
  }
  EXPECT_GT(counts.committed, 20 * num_seeds);
  EXPECT_GT(counts.rolled_back, 10 * num_seeds);
  EXPECT_GT(counts.undone, 8 * num_seeds);
}

}  // namespace
}  // namespace trivet
