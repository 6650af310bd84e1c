// SPDX-License-Identifier: BSD-3-Clause
#include "tools/shape_arguments.h"

#include "tools/arguments.h"
#include "tools/numbers.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

/// Numbers such as "1:2", with colons, blanks or commas between them.
std::vector<double> parse_ratio(std::string text, RegularShape shape, std::size_t free, Problems& problems) {
  if (text.empty()) return {};
  std::replace(text.begin(), text.end(), ':', ' ');
  const std::vector<std::string> names = shape == RegularShape::cylinder
                                             ? std::vector<std::string>{"diameter", "height"}
                                             : std::vector<std::string>(free, "edge");
  std::vector<double> parts = parse_numbers("--aspect-ratio", text, names, problems);
  if (shape != RegularShape::cylinder || parts.size() != 2) return parts;
  return {parts[1] / parts[0]};
}

/// "x=1 y=2": some of the free positions.
void parse_center(const std::string& text, const std::vector<std::string>& names, WorkspaceQuestion& question,
                  Problems& problems) {
  for (const std::string& word : words_of_list(text)) {
    const std::size_t equals = word.find('=');
    const auto found = std::find(names.begin(), names.end(), word.substr(0, equals));
    if (equals == std::string::npos || found == names.end()) {
      problems.push_back("--center has '" + word + "'; give free positions with their values, such as \"" +
                         names.front() + "=0.5\".");
      continue;
    }
    const auto value = parse_numbers("--center", word.substr(equals + 1), {*found}, problems);
    if (!value.empty()) question.center[static_cast<std::size_t>(found - names.begin())] = value.front();
  }
}

void parse_angle(const std::string& text, const std::vector<std::string>& names, std::size_t free,
                 WorkspaceQuestion& question, Problems& problems) {
  if (text.empty()) return;
  if (names.size() <= free) {
    problems.emplace_back("--orientation is of a free angle, but none is free here; leave it out.");
    return;
  }
  const Box range = parse_region("--orientation", {names[free]}, text, problems);
  question.angle = AngleRange{range.lower[0], range.upper[0]};
}

/// Where and how a shape may lie, of the kind that `question` has.
void parse_placement(const ShapeArguments& arguments, const Manipulator& manipulator,
                     const std::optional<MapSlice>& slice, WorkspaceQuestion& question, Problems& problems) {
  const std::size_t free = free_positions(manipulator, slice);
  const auto names = slice ? coordinate_names(*slice) : coordinate_names(manipulator.task_space());
  question.ratio = parse_ratio(arguments.ratio, question.shape, free, problems);
  parse_center(arguments.center, {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(free)}, question,
               problems);
  parse_angle(arguments.angle, names, free, question, problems);
}

}  // namespace

WorkspaceQuestion parse_shape(const ShapeArguments& arguments, const Manipulator& manipulator,
                              const std::optional<MapSlice>& slice, Problems& problems) {
  WorkspaceQuestion question;
  Problems own;
  const auto shape = shape_named(arguments.name);
  if (shape) {
    question.shape = *shape;
    own = problems_of(manipulator, slice, question);
    if (own.empty()) parse_placement(arguments, manipulator, slice, question, own);
    if (own.empty()) own = problems_of(manipulator, slice, question);
  } else {
    own.push_back("--shape is '" + arguments.name + "'; give box, square, disc, cylinder or ball.");
  }
  problems.insert(problems.end(), own.begin(), own.end());
  return question;
}

double parse_gap(const ShapeArguments& arguments, Problems& problems) {
  const std::string& text = arguments.gap;
  if (text.empty()) return WorkspaceOptions().gap;
  const double gap = parse_positive("--gap", text, problems);
  if (gap >= 1.0) problems.emplace_back("--gap is a share of the size; give one below 1, such as 0.01.");
  return gap;
}

std::vector<Option> shape_options(ShapeArguments& arguments, bool is_required) {
  return {
      {"--shape", "disc", "Box or square, with edges along the axes; disc, cylinder along z, or ball",
       &arguments.name, is_required},
      {"--center", "\"x=1 y=2\"", "Hold all or some coordinates of the center [m]", &arguments.center, false,
       Words::assignments},
      {"--aspect-ratio", "\"1:2\"",
       "Edges of a box to each other, or diameter to height of a cylinder; by default all equal",
       &arguments.ratio, false, Words::numbers},
      {"--orientation", "\"phi=-0.2:0.2\"",
       "Where an angle is free: the range of it that must be possible all over the shape [rad]; by default "
       "every one",
       &arguments.angle},
      {"--gap", "SHARE", "Between the bounds of the size, of the upper one, by default 0.01",
       &arguments.gap}};
}

}  // namespace parallel_aspects::tools
