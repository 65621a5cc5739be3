// Barriers follow from what was done before: as few as are right, and no fewer.
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/tracker.h"

#include <gtest/gtest.h>

namespace gg::gpu::vulkan {
namespace {

constexpr VkPipelineStageFlags2 output = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkAccessFlags2 output_write =
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;

TEST(vulkan_tracker, what_was_drawn_is_waited_for_by_its_reader_once) {
  State state;
  advance(state, color_target(true));
  const auto first = advance(state, sampled_by(drawing_stages));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->source_stages, output);
  EXPECT_EQ(first->source_access, output_write);
  EXPECT_EQ(first->stages, drawing_stages);
  EXPECT_EQ(first->from, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  EXPECT_EQ(first->to, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_FALSE(advance(state, sampled_by(drawing_stages)));
}

TEST(vulkan_tracker, a_reader_in_another_stage_waits_for_the_change_of_layout) {
  State state;
  advance(state, color_target(true));
  advance(state, sampled_by(drawing_stages));
  const auto other = advance(state, sampled_by(computing_stages));
  ASSERT_TRUE(other);
  // Through the stages that waited for the change: it happened before them and nowhere else.
  EXPECT_EQ(other->source_stages, drawing_stages);
  EXPECT_EQ(other->source_access, 0u);
  EXPECT_EQ(other->from, other->to);
  EXPECT_FALSE(advance(state, sampled_by(computing_stages)));
  EXPECT_FALSE(advance(state, sampled_by(drawing_stages)));
}

TEST(vulkan_tracker, a_write_waits_for_all_readers) {
  State state;
  advance(state, color_target(true));
  advance(state, sampled_by(drawing_stages));
  advance(state, sampled_by(computing_stages));
  const auto write = advance(state, color_target(false));
  ASSERT_TRUE(write);
  EXPECT_EQ(write->source_stages, drawing_stages | computing_stages);
  EXPECT_EQ(write->from, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL); // what was drawn is kept
}

TEST(vulkan_tracker, a_write_that_overwrites_discards) {
  State state;
  advance(state, color_target(true));
  advance(state, sampled_by(drawing_stages));
  const auto write = advance(state, color_target(true));
  ASSERT_TRUE(write);
  EXPECT_EQ(write->from, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(write->source_stages, drawing_stages);
}

TEST(vulkan_tracker, a_write_waits_for_the_write_before_it) {
  State state;
  advance(state, stored_by(computing_stages));
  const auto again = advance(state, stored_by(computing_stages));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->source_stages, computing_stages);
  EXPECT_EQ(again->source_access, stored_by(computing_stages).access);
  EXPECT_EQ(again->from, again->to);
}

TEST(vulkan_tracker, a_buffer_that_nobody_wrote_needs_nothing) {
  State state;
  EXPECT_FALSE(advance(state, buffer_read(true)));
  EXPECT_FALSE(advance(state, buffer_read(false)));
  const auto write = advance(state, buffer_written(false));
  ASSERT_TRUE(write); // after both readers
  EXPECT_EQ(write->source_stages, buffer_read(true).stages | buffer_read(false).stages);
  EXPECT_EQ(write->source_access, 0u);
  const auto read = advance(state, buffer_read(true));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->source_stages, computing_stages);
  EXPECT_NE(read->source_access & VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, 0u);
}

} // namespace
} // namespace gg::gpu::vulkan
