// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/refusal.h"

#include "urdf/load_mechanism.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_lines = 5;

struct OutOfTime {};

// No problems where time does not suffice.
Refusal diagnosed(const SetupSubject& subject, const SetupDraft& draft, std::size_t joints) {
  LoadSearch search;
  search.as_options = true;
  search.checkpoint = [&subject, joints] {
    if (subject.control.is_over()) throw OutOfTime{};
    subject.control.count_attempt(joints);
  };
  try {
    load_mechanism(subject.urdf_text, subject.urdf_name, config_text(draft), name_of_choice, "", search);
  } catch (const CorrectableDescription& correctable) {
    return {correctable.problems(), true};
  } catch (const InvalidDescription& invalid) {
    return {invalid.problems(), false};
  } catch (const OutOfTime&) {
  }
  return {};
}

Refusal in_options(const SetupSubject& subject, const SetupDraft& draft, Refusal refusal) {
  Problems& problems = refusal.problems;
  if (problems.empty()) return refusal;
  problems.front() = subject.urdf_name + " was tried with " + options_for(draft) +
                     ", and does not load: " + problems.front();
  if (problems.size() <= most_lines) return refusal;
  const std::size_t more = problems.size() - (most_lines - 1);
  problems.resize(most_lines - 1);
  problems.push_back(std::to_string(more) + " more of its kind.");
  return refusal;
}

}  // namespace

Refusal refusal_of(const SetupSubject& subject, const ClosedResult& found) {
  if (found.tried.empty()) return {found.problems, false};
  Refusal first = diagnosed(subject, found.tried.front(), found.joints_in_loops);
  if (first.problems.empty()) first.problems = found.problems;
  first = in_options(subject, found.tried.front(), first);
  for (std::size_t k = 1; k < found.tried.size() && !first.has_remedy; ++k) {
    const Refusal other = diagnosed(subject, found.tried[k], found.joints_in_loops);
    if (other.has_remedy) return in_options(subject, found.tried[k], other);
  }
  return first;
}

}  // namespace parallel_aspects
