// The frame graph: what follows from what passes declare.
#include "frame/graph.h"

#include <gtest/gtest.h>

namespace gg::test {
namespace {

using frame::Graph;

frame::Pass pass(std::vector<std::size_t> reads, std::vector<std::size_t> writes) {
  frame::Pass pass;
  for (const std::size_t target : reads)
    pass.reads.push_back({"", {target}});
  for (const std::size_t target : writes)
    pass.colors.push_back({.part = {target}});
  return pass;
}

Graph chain(std::initializer_list<const char*> names) {
  Graph graph{.width = 8, .height = 4};
  for (const char* name : names)
    graph.target({.name = name});
  return graph;
}

} // namespace

TEST(graph, targets_share_memory_only_where_their_lives_do_not_overlap) {
  Graph graph = chain({"a", "b", "c"});
  graph.passes = {pass({}, {0}), pass({0}, {1}), pass({1}, {2})};
  const frame::Allocation allocation = allocate(graph);
  EXPECT_EQ(allocation.texture_of[0],
            allocation.texture_of[2]); // a is read last where b is written
  EXPECT_NE(allocation.texture_of[0], allocation.texture_of[1]);
  EXPECT_NE(allocation.texture_of[1], allocation.texture_of[2]);
  EXPECT_EQ(allocation.bytes, 2 * frame::bytes_of(graph.targets[0]));

  graph.passes.push_back(pass({0, 2}, {}));
  EXPECT_NE(allocate(graph).texture_of[0], allocate(graph).texture_of[2]);
}

TEST(graph, a_result_and_what_differs_in_size_share_with_nothing) {
  Graph graph = chain({"a", "b"});
  graph.target({.name = "half", .width = 4, .height = 2});
  graph.target({.name = "shown", .is_result = true});
  graph.passes = {pass({}, {0}), pass({}, {1}), pass({}, {2}), pass({}, {3})};
  const frame::Allocation allocation = allocate(graph);
  EXPECT_EQ(allocation.texture_of[0], allocation.texture_of[1]);
  EXPECT_EQ(allocation.first.size(), 3u);
}

TEST(graph, a_target_is_declared_at_its_first_mention_with_the_size_of_the_picture) {
  Graph graph{.width = 8, .height = 4};
  const std::size_t color = graph.target({.name = "color"});
  EXPECT_EQ(graph.target({.name = "color"}), color);
  EXPECT_EQ(frame::bytes_of(graph.targets[color]), 8u * 4u * 16u);
  EXPECT_EQ(graph.find("depth"), nullptr);
  EXPECT_FALSE(graph.is_written(color));
  graph.passes.push_back(pass({}, {color}));
  EXPECT_TRUE(graph.is_written(color));
}

} // namespace gg::test
