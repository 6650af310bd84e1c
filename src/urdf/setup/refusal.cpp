// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/refusal.h"

#include "urdf/load_search.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace parallel_aspects {
namespace {

struct OutOfTime {};

// Nothing where time does not suffice.
Problems diagnosed(const SetupSubject& subject, const SetupDraft& draft) {
  LoadSearch search;
  search.as_options = true;
  search.checkpoint = [&subject] {
    if (subject.control.is_over()) throw OutOfTime{};
  };
  try {
    load_mechanism(subject.urdf_text, subject.urdf_name, config_text(draft), name_of_choice, "", search);
  } catch (const InvalidDescription& invalid) {
    return invalid.problems();
  } catch (const OutOfTime&) {
  }
  return {};
}

Problems in_options(const SetupSubject& subject, const SetupDraft& draft, const Problems& reasons) {
  Problems problems;
  for (const std::string& reason : reasons)
    problems.push_back(subject.urdf_name + " was tried with " + options_for(draft) +
                       ", and does not load: " + reason);
  return problems;
}

}  // namespace

bool any_remedy(const Problems& problems) {
  return std::any_of(problems.begin(), problems.end(), [](const std::string& problem) {
    return problem.find("makes it a robot in") != std::string::npos ||
           problem.find("would make it one") != std::string::npos;
  });
}

Problems refusal_of(const SetupSubject& subject, const ClosedResult& found) {
  if (found.tried.empty()) return found.problems;
  Problems first = diagnosed(subject, found.tried.front());
  if (first.empty()) first = found.problems;
  first = in_options(subject, found.tried.front(), first);
  for (std::size_t k = 1; k < found.tried.size() && !any_remedy(first); ++k) {
    const Problems reasons = diagnosed(subject, found.tried[k]);
    if (any_remedy(reasons)) return in_options(subject, found.tried[k], reasons);
  }
  return first;
}

}  // namespace parallel_aspects
