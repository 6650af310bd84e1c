// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_PROBLEMS_H
#define PARALLEL_ASPECTS_MODEL_PROBLEMS_H

#include <stdexcept>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whole messages; each names the file or parameter, the joint or link at fault, and what to do about it.
using Problems = std::vector<std::string>;

/// Thrown while loading or constructing, and nowhere else. Carries every problem found, not just the first.
class InvalidDescription : public std::runtime_error {
 public:
  /// At least one is kept, a general one where there is none; `what()` holds all of them, a line each.
  explicit InvalidDescription(Problems problems);

  /// A message each; at least one.
  const Problems& problems() const noexcept { return problems_; }

 private:
  Problems problems_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_PROBLEMS_H
