// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/refusal.h"

#include "urdf/load_search.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {
namespace {

struct OutOfTime {};

// No problems where time does not suffice.
Refusal diagnosed(const SetupSubject& subject, const SetupDraft& draft) {
  LoadSearch search;
  search.as_options = true;
  search.checkpoint = [&subject] {
    if (subject.control.is_over()) throw OutOfTime{};
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
  for (std::string& problem : refusal.problems)
    problem = subject.urdf_name + " was tried with " + options_for(draft) + ", and does not load: " + problem;
  return refusal;
}

}  // namespace

Refusal refusal_of(const SetupSubject& subject, const ClosedResult& found) {
  if (found.tried.empty()) return {found.problems, false};
  Refusal first = diagnosed(subject, found.tried.front());
  if (first.problems.empty()) first.problems = found.problems;
  first = in_options(subject, found.tried.front(), first);
  for (std::size_t k = 1; k < found.tried.size() && !first.has_remedy; ++k) {
    const Refusal other = diagnosed(subject, found.tried[k]);
    if (other.has_remedy) return in_options(subject, found.tried[k], other);
  }
  return first;
}

}  // namespace parallel_aspects
