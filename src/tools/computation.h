// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_COMPUTATION_H
#define PARALLEL_ASPECTS_TOOLS_COMPUTATION_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/problems.h"
#include "tools/command.h"
#include "tools/progress_bar.h"
#include "tools/subcommands.h"

#include <optional>

namespace parallel_aspects::tools {

/// Ctrl-C ends a question early; nothing is printed then.
inline MapControl control_of(const Surroundings& surroundings) {
  MapControl control;
  control.cancelled = surroundings.interrupted;
  return control;
}

/// What `compute(const MapControl&)` results in when complete, with a progress bar where messages go to a
/// terminal. Throws Interrupted at Ctrl-C, and InvalidDescription with the message where it refuses.
template <class Compute>
auto completed(const Surroundings& surroundings, const Compute& compute) {
  std::optional<ProgressBar> bar;
  MapControl control = control_of(surroundings);
  if (surroundings.messages_on_terminal) {
    bar.emplace(surroundings.messages);
    control.progress = [&bar](double share) { bar->show(share); };
  }
  auto result = compute(control);
  if (result.status == MapStatus::cancelled) throw Interrupted{};
  if (result.status == MapStatus::refused) throw InvalidDescription({result.message});
  return result;
}

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_COMPUTATION_H
