// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "urdf/diagnosis/closure_gaps.h"
#include "urdf/diagnosis/diagnosis.h"
#include "urdf/mechanism_recognition.h"

#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

// Spherical robots have angles.
bool has_lengths(const Mechanism::Contents& contents) {
  return contents.manipulator->task_space() != TaskSpace::SO3;
}

// Of the legs, at the joint value zero where they change.
std::string lengths_of(const Mechanism::Contents& contents) {
  if (!has_lengths(contents)) return "";
  std::string text;
  for (const Leg& leg : contents.manipulator->legs())
    text += (text.empty() ? ", with legs of " : ", ") + number_text(std::sqrt(leg.squared_distance(0.0)));
  return text + " m";
}

// The list for the YAML, with the lengths that it makes; nothing where it makes no robot.
std::optional<Note> list_text(const RecognisedEnds& ends, const ResolvedConfig& listed) {
  Problems ignored;
  const auto contents = ends.recognise(ends.subject.shared_tree, listed, ignored);
  if (!contents) return std::nullopt;
  return "write " +
         closures_entry(ends.subject.tree, with_known_types(ends.subject.shared_tree, listed, ends.attempt),
                        ends.subject.files) +
         lengths_of(*contents);
}

// What holds ends apart as they are at zero, as a list.
ResolvedConfig as_drawn(const RecognisedEnds& ends) {
  ResolvedConfig drawn = ends.subject.resolved;
  for (Closure& closure : drawn.closures) {
    closure.at_zero.reset();
    closure.weld = Weld::none;
  }
  return drawn;
}

// Of a robot that is drawn open.
Note note_of_meeting(const RecognisedEnds& ends, const Mechanism::Contents& contents) {
  const auto drawn = list_text(ends, as_drawn(ends));
  const std::string remedies = remedies_of_places(ends.subject, ends.attempt);
  return "they are taken to meet" + lengths_of(contents) + "; if " +
         (drawn ? "they are held so, as by simulators, " + *drawn : Note()) +
         (drawn && !remedies.empty() ? "; if " : "") +
         (!drawn || !remedies.empty() ? "they are to meet at zero, " : "") +
         (!remedies.empty() ? remedies
          : drawn           ? ""
                            : "correct the origins of the joints in their loops");
}

Note note_of_holding(const RecognisedEnds& ends, const Mechanism::Contents& contents) {
  const auto together = list_text(ends, as_listed(ends.subject.tree, ends.subject.resolved));
  const std::string remedies = remedies_of_places(ends.subject, ends.attempt);
  return "they are held so, as by simulators" + lengths_of(contents) + "; if they are to meet, " + remedies +
         (!remedies.empty() && together ? ", or " : "") +
         (together           ? *together
          : remedies.empty() ? Note("correct the origins of the joints in their loops")
                             : Note());
}

}  // namespace

void note_ends(const RecognisedEnds& ends, Mechanism::Contents& contents) {
  auto crossed = crossed_ends_notes(ends.subject, ends.attempt);
  if (!crossed.empty()) {
    std::move(crossed.begin(), crossed.end(), std::back_inserter(contents.notes));
    return;
  }
  for (Note& note : misplaced_ends_notes(ends.subject, ends.attempt))
    contents.notes.push_back(std::move(note));
  const std::string apart = end_gaps_text(ends.subject.tree, ends.subject.resolved);
  if (apart.empty()) return;
  contents.notes.push_back(
      ends.subject.file() + " has ends of closures apart while all joints are zero, " + apart + ", and " +
      (ends.ends_meet ? note_of_meeting(ends, contents) : note_of_holding(ends, contents)) + ".");
}

}  // namespace parallel_aspects
