// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/messages.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Kind = Note::Piece::Kind;

TEST(Note, PiecesMakeOneText) {
  const std::string file = "robot.urdf";
  const Note note = file + " holds joints still: " + listed_names({"a", "b"}) + ".";
  EXPECT_EQ(note.text(), "robot.urdf holds joints still: 'a', 'b'.");
  EXPECT_TRUE(note.has(Kind::names));
  EXPECT_FALSE(note.has(Kind::closures));
}

TEST(Note, ClosuresAreAsInTheYaml) {
  const Note note = "write " + Note(Kind::closures, {"{type: point}", "{type: fixed}"}) + " there";
  EXPECT_EQ(note.text(), "write closures: [{type: point}, {type: fixed}] there");
  EXPECT_TRUE(note.has(Kind::closures));
}

TEST(Note, AListOfNamesMayHaveOneOrNone) {
  EXPECT_EQ(listed_names({"a"}).text(), "'a'");
  EXPECT_EQ(listed_names({}).text(), "");
  EXPECT_EQ(Note().text(), "");
}

TEST(Note, AllTextsAreInOrder) {
  EXPECT_EQ(texts_of({"one", listed_names({"two", "three"})}),
            (std::vector<std::string>{"one", "'two', 'three'"}));
}

}  // namespace
}  // namespace parallel_aspects
