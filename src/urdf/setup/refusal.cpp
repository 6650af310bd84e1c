// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/refusal.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {
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
