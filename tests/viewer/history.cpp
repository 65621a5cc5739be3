#include "viewer/history.h"

#include <gtest/gtest.h>

namespace gg::viewer {
namespace {

Edits gold(const char* alpha) {
  return {Edit{}, Edit{.preset = "gold", .settings = {{"alpha", alpha}}}};
}

TEST(history, goes_back_and_forth) {
  History history;
  history.note(gold("0.1"));
  history.note(gold("0.2"));
  EXPECT_EQ(history.undo(), gold("0.1"));
  EXPECT_EQ(history.undo(), Edits{});
  EXPECT_EQ(history.undo(), Edits{});
  EXPECT_EQ(history.redo(), gold("0.1"));
  EXPECT_EQ(history.redo(), gold("0.2"));
  EXPECT_EQ(history.redo(), gold("0.2"));
}

TEST(history, notes_no_state_twice) {
  History history;
  history.note(gold("0.1"));
  history.note(gold("0.1"));
  EXPECT_EQ(history.undo(), Edits{});
}

TEST(history, a_change_after_undo_replaces_what_was_undone) {
  History history;
  history.note(gold("0.1"));
  history.note(gold("0.2"));
  history.undo();
  history.note(gold("0.3"));
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo(), gold("0.1"));
}

TEST(history, an_edit_that_says_nothing_is_no_state) {
  History history;
  history.note({Edit{}, Edit{}});
  EXPECT_FALSE(history.can_undo());
}

TEST(edits, become_options_that_name_the_material_by_number) {
  View view{.materials = {"*=glass"}, .edits = gold("0.25")};
  EXPECT_EQ(view.all_materials(), (std::vector<std::string>{"*=glass", "#1=gold,alpha=0.25"}));
  view.edits[1].preset.clear();
  EXPECT_EQ(view.all_materials().back(), "#1=,alpha=0.25");
}

} // namespace
} // namespace gg::viewer
