// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/load_mechanism.h"
#include "urdf/mechanism_contents.h"
#include "urdf/setup/closed_search.h"

#include <cstddef>
#include <memory>
#include <string>

namespace parallel_aspects {
namespace {

struct SearchIsLate {};

// What is tried, for messages that name it: no file has it.
constexpr const char* name_of_choice = "this choice";

// A place that an answer gives is a frame of its link, as the YAML has it.
LinkFrame frame_of(const Tree& tree, LinkFrame frame) {
  if (const auto placed = placed_frame(tree.links[frame.link])) {
    const TreeJoint& joint = tree.joints[*tree.joint_above[frame.link]];
    frame = {joint.parent, joint.origin * frame.in_link};
  }
  return frame;
}

NamedDescription named(const SetupSubject& subject, const SetupDraft& draft, const SetupClosures& closures,
                       const SourceNames& files) {
  const auto link_named = [&](const SetupCandidate& candidate) {
    return *subject.tree.link_named(candidate.values.front());
  };
  NamedDescription description{subject.tree_read, {}, {}};
  ResolvedConfig& resolved = description.resolved;
  resolved.base = link_named(draft.base_link);
  resolved.closure_dialect = closures.dialect;
  resolved.closures = closures.all;
  for (std::size_t k = closures.described; k < closures.all.size(); ++k) {
    Closure& closure = resolved.closures[k];
    closure.type = *closure_type_named(draft.closure_type);
    for (LinkFrame& frame : closure.frames) frame = frame_of(subject.tree, frame);
    closure.name =
        subject.tree.links[closure.frames[0].link] + " - " + subject.tree.links[closure.frames[1].link];
  }
  for (const std::string& joint : draft.actuated_joints.values)
    resolved.actuated_joints.variables.push_back(
        *subject.tree.joints[*subject.tree.joint_named(joint)].variable);
  const LinkFrame point = frame_of(subject.tree, {link_named(draft.operational_point)});
  ConfiguredFrame& configured = description.config.operational_point;
  configured = {subject.tree.links[point.link], point.in_link, "",
                !placed_frame(draft.operational_point.values.front())};
  Problems unused;
  Tree tree = *subject.tree_read;
  add_operational_point(configured, files, tree, unused);
  resolved.actuated_joints.platform_link = *tree.link_named(configured.link);
  if (!configured.is_link) description.tree = std::make_shared<const Tree>(std::move(tree));
  return description;
}

}  // namespace

std::shared_ptr<const Mechanism> tried(const SetupSubject& subject, const SetupDraft& draft,
                                       const SetupClosures& closures, std::size_t joints_in_loops,
                                       bool looks_for_remedies, Problems& problems, bool* explained) {
  LoadSearch search;
  search.looks_for_remedies = looks_for_remedies;
  search.is_guess = true;
  search.as_options = true;
  search.checkpoint = [&] {
    if (subject.control.is_over()) throw SearchIsLate{};
    subject.control.count_attempt(joints_in_loops);
  };
  const SourceNames files{subject.urdf_name, name_of_choice, true};
  try {
    return std::make_shared<const Mechanism>(
        recognise_named(named(subject, draft, closures, files), files, search));
  } catch (const ExplainedDescription& known) {
    problems = known.problems();
    if (explained != nullptr) *explained = true;
  } catch (const InvalidDescription& invalid) {
    problems = invalid.problems();
  } catch (const SearchIsLate&) {
  }
  return nullptr;
}

namespace {

constexpr std::size_t most_lines = 5;  // that a refusal has, so that its first one stays in sight

// No problems where time does not suffice.
Refusal explained(const SetupSubject& subject, const ClosedResult& found, const SetupDraft& draft) {
  Refusal refusal;
  tried(subject, draft, found.closures, found.joints_in_loops, true, refusal.problems, &refusal.is_explained);
  return refusal;
}

// The options come last: what is wrong comes first.
Refusal with_options(const SetupSubject& subject, const SetupDraft& draft, Refusal refusal) {
  Problems& problems = refusal.problems;
  if (problems.empty()) return refusal;
  if (problems.size() > most_lines) {
    const std::size_t kept = most_lines - 1, more = problems.size() - kept;
    problems.resize(kept);
    problems.push_back(std::to_string(more) + " more of its kind.");
  }
  problems.back() += " " + subject.urdf_name + " was read with " + options_for(draft) + ".";
  return refusal;
}

}  // namespace

Refusal refusal_of(const SetupSubject& subject, const ClosedResult& found) {
  if (found.tried.empty()) return {found.problems, false};
  Refusal first = explained(subject, found, found.tried.front());
  if (first.problems.empty()) first.problems = found.problems;
  first = with_options(subject, found.tried.front(), first);
  for (std::size_t k = 1; k < found.tried.size() && !first.is_explained; ++k)
    if (const Refusal other = explained(subject, found, found.tried[k]); other.is_explained)
      return with_options(subject, found.tried[k], other);
  return first;
}

}  // namespace parallel_aspects
