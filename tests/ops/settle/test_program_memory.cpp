// Linear programs that were solved before give the same bits, and only those.

#include <gtest/gtest.h>

#include "ops/settle/program_memory.h"

namespace trivet {
namespace {

// The least cost of x + y = 1, x <= most.
LinearProgram program(double cost_of_x, double most) {
  LinearProgram out;
  const int row = out.add_row(1, 1);
  out.add_column(std::vector<LinearProgram::Entry>{{row, 1}}, cost_of_x, most);
  out.add_column(std::vector<LinearProgram::Entry>{{row, 1}}, 2);
  return out;
}

TEST(ProgramMemory, AnswersTheSameProgramAlone) {
  const ProgramMemory memory;
  const auto first = program(1, 0.25).solve(false);
  ASSERT_TRUE(first.optimal);
  EXPECT_DOUBLE_EQ(first.objective, 1.75);
  EXPECT_EQ(memory.num_remembered(), 1u);
  const auto again = program(1, 0.25).solve(false);
  EXPECT_EQ(memory.num_remembered(), 1u);
  EXPECT_EQ(again.x, first.x);
  EXPECT_EQ(again.prices, first.prices);
  EXPECT_EQ(again.objective, first.objective);
  EXPECT_DOUBLE_EQ(program(1, 0.75).solve(false).objective, 1.25);
  EXPECT_DOUBLE_EQ(program(3, 0.25).solve(false).objective, 2);
  EXPECT_DOUBLE_EQ(program(3, 0.25).solve(true).objective, 2);
  EXPECT_DOUBLE_EQ(program(3, 0.25).solve_by_dual(false).objective, 2);
  EXPECT_EQ(memory.num_remembered(), 5u);
}

TEST(ProgramMemory, RemembersWhileTheFirstOneLives) {
  EXPECT_EQ(ProgramMemory::current(), nullptr);
  {
    const ProgramMemory first;
    {
      const ProgramMemory second;
      program(1, 0.25).solve(false);
      EXPECT_EQ(second.num_remembered(), 0u);
    }
    EXPECT_EQ(ProgramMemory::current(), &first);
    EXPECT_EQ(first.num_remembered(), 1u);
  }
  EXPECT_EQ(ProgramMemory::current(), nullptr);
  EXPECT_DOUBLE_EQ(program(1, 0.25).solve(false).objective, 1.75);
}

TEST(ProgramMemory, KnowsWhichHaveNoSolution) {
  const ProgramMemory memory;
  LinearProgram impossible;
  impossible.add_column(std::vector<LinearProgram::Entry>{{impossible.add_row(-1, -1), 1}}, 1);
  LinearProgram::Basis basis{1, 2, 3};
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(impossible.solve(false, &basis).optimal);
    EXPECT_EQ(basis.size(), 3u) << "it is left as it was";
  }
}

TEST(ProgramMemory, GivesTheBasisBack) {
  const ProgramMemory memory;
  LinearProgram::Basis first, second;
  const auto a = program(1.5, 0.5).solve(false, &first);
  const auto b = program(1.5, 0.5).solve(false, &second);
  EXPECT_EQ(memory.num_remembered(), 1u);
  EXPECT_EQ(first.size(), 3u);
  EXPECT_EQ(first, second);
  EXPECT_EQ(a.x, b.x);
  // From another start it is another question.
  program(1.5, 0.5).solve(false, &second);
  EXPECT_EQ(memory.num_remembered(), 2u);
}

TEST(ProgramMemory, LeavesOutLargePrograms) {
  LinearProgram large;
  const int row = large.add_row(1, 1);
  for (int i = 0; i < 10'001; ++i)
    large.add_column(std::vector<LinearProgram::Entry>{{row, 1}}, 2 + i);
  const ProgramMemory memory;
  EXPECT_DOUBLE_EQ(large.solve(false).objective, 2);
  EXPECT_EQ(memory.num_remembered(), 0u);
}

TEST(ProgramMemory, ForgetsTheOlderHalf) {
  ProgramMemory memory(4000);
  const auto question = [](int number) { return std::string(100, static_cast<char>(number)); };
  for (int i = 0; i < 100; ++i) {
    ProgramMemory::Answer answer;
    answer.solution.objective = i;
    memory.remember(question(i), answer);
    ASSERT_LE(memory.num_remembered(), 40u);
    for (int k = std::max(0, i - 19); k <= i; ++k) {
      const ProgramMemory::Answer* const known = memory.find(question(k));
      ASSERT_TRUE(known) << i << ' ' << k;
      EXPECT_EQ(known->solution.objective, k);
    }
  }
  EXPECT_FALSE(memory.find(question(0)));
}

}  // namespace
}  // namespace trivet
