// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_COMPUTATION_H
#define PARALLEL_ASPECTS_TOOLS_COMPUTATION_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/problems.h"
#include "tools/command.h"
#include "tools/subcommands.h"

#include <optional>
#include <ostream>
#include <string>

namespace parallel_aspects::tools {

/// A line on a terminal that shows the share of work done, and is gone when the bar is.
class ProgressBar {
 public:
  explicit ProgressBar(std::ostream& terminal) : terminal_(terminal) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the share done, 0 to 1, if it changed visibly.
  void show(double share);

  /// The same, with the time that is left at the speed so far: `seconds` since the share was `from`.
  void show(double share, double from, double seconds);

 private:
  void draw(double share, const std::string& more);

  std::ostream& terminal_;
  std::string drawn_;
};

/// Ctrl-C ends a question early; nothing is printed then.
inline MapControl control_of(const Surroundings& surroundings) {
  MapControl control;
  control.cancelled = surroundings.interrupted;
  return control;
}

/// A computation that Ctrl-C ends, with a progress bar where messages go to a terminal. The bar is gone with
/// the object.
class ShownComputation {
 public:
  explicit ShownComputation(const Surroundings& surroundings) : control_(control_of(surroundings)) {
    if (!surroundings.messages_on_terminal) return;
    bar_.emplace(surroundings.messages);
    control_.progress = [this](double share) { bar_->show(share); };
  }
  ShownComputation(const ShownComputation&) = delete;
  ShownComputation& operator=(const ShownComputation&) = delete;

  const MapControl& control() const { return control_; }

 private:
  MapControl control_;
  std::optional<ProgressBar> bar_;
};

/// Throws Interrupted where it was cancelled, and InvalidDescription with the message where it was refused.
template <class Result>
Result required(Result result) {
  if (result.status == MapStatus::cancelled) throw Interrupted{};
  if (result.status == MapStatus::refused) throw InvalidDescription({result.message});
  return result;
}

/// What `compute(const MapControl&)` results in when complete, with a progress bar where messages go to a
/// terminal. Throws Interrupted at Ctrl-C, and InvalidDescription with the message where it refuses.
template <class Compute>
auto completed(const Surroundings& surroundings, const Compute& compute) {
  const ShownComputation shown(surroundings);
  return required(compute(shown.control()));
}

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_COMPUTATION_H
