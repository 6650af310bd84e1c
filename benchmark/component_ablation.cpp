// SPDX-License-Identifier: BSD-3-Clause
//
// What each part of joining components and proving them apart is good for: maps of shipped robots, with one
// part switched off at a time. scripts/component_ablation runs it for all of them and makes the tables.
#include "aspects/components/component_policy.h"
#include "aspects/map/map_computation.h"
#include "aspects/map/map_plan.h"

#include "support/robots/shipped.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using parallel_aspects::ComponentPolicy;
using parallel_aspects::Manipulator;
using parallel_aspects::MapOptions;

constexpr const char* help =
    "component_ablation ROBOT [HALVINGS [LIMIT [SWITCH...]]]\n"
    "  HALVINGS: of the default resolution, by default 0\n"
    "  LIMIT: of one map, in seconds of processor time, by default 100\n"
    "  SWITCH: which to turn off, one at a time; by default all, after a run with none off\n"
    "Prints a line for each: robot, halvings, switch, components, pairs unresolved, proved count, "
    "indeterminate\n"
    "leaves, and processor time of one thread [s]: the least of three runs or of two seconds. A map that "
    "comes\n"
    "to the limit has '-' in place of counts. The switches, see ComponentPolicy:\n ";

/// A part that can be left out.
struct Switch {
  const char* name;
  void (*turn_off)(ComponentPolicy&);
};

const std::vector<Switch> switches{
    {"none", [](ComponentPolicy&) {}},
    {"wedges", [](ComponentPolicy& policy) { policy.boxes.wedges = false; }},
    {"shells", [](ComponentPolicy& policy) { policy.boxes.shells = false; }},
    {"faces", [](ComponentPolicy& policy) { policy.boxes.faces = false; }},
    {"joins_across_faces", [](ComponentPolicy& policy) { policy.joins_across_faces = false; }},
    {"climbs", [](ComponentPolicy& policy) { policy.climbs = false; }},
    {"look_everywhere", [](ComponentPolicy& policy) { policy.max_leaves_to_look_into = 0; }},
    {"searches_meetings", [](ComponentPolicy& policy) { policy.searches_meetings = false; }},
    {"searches_indeterminate", [](ComponentPolicy& policy) { policy.searches_indeterminate = false; }},
    {"searches_contacts", [](ComponentPolicy& policy) { policy.searches_contacts = false; }},
    {"examines", [](ComponentPolicy& policy) { policy.examines = false; }},
    {"tries", [](ComponentPolicy& policy) { policy.tries = false; }},
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A map, and how long it took; none where that came to the limit.
struct Run {
  std::shared_ptr<const parallel_aspects::AspectMap> map;
  double seconds = 0.0;
};

Run run(const std::shared_ptr<const Manipulator>& robot, const MapOptions& options,
        const ComponentPolicy& policy, double limit) {
  std::atomic<bool> cancelled{false}, ended{false};
  const double start = processor_seconds();
  std::thread watch([&] {
    while (!ended && !cancelled) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      cancelled = processor_seconds() - start > limit;
    }
  });
  parallel_aspects::MapControl control;
  control.cancelled = &cancelled;
  const auto result = compute_aspect_map(robot, options, control, policy);
  const double seconds = processor_seconds() - start;
  ended = true;
  watch.join();
  return {result.map, seconds};
}

/// Noise only adds to times.
Run best_run(const std::shared_ptr<const Manipulator>& robot, const MapOptions& options,
             const ComponentPolicy& policy, double limit) {
  constexpr int max_runs = 3;
  constexpr double enough_seconds = 2.0;
  Run best = run(robot, options, policy, limit);
  double all = best.seconds;
  for (int i = 1; best.map && i < max_runs && all < enough_seconds; ++i) {
    const Run next = run(robot, options, policy, limit);
    all += next.seconds;
    best.seconds = std::min(best.seconds, next.seconds);
  }
  return best;
}

void print(const char* robot, int halvings, const char* name, const Run& run) {
  std::printf("%s %d %s ", robot, halvings, name);
  if (run.map)
    std::printf("%zu %zu %zu %zu", run.map->aspects().size(), run.map->unresolved().size(),
                run.map->proved_count(), run.map->indeterminate_leaves());
  else
    std::printf("- - - -");
  std::printf(" %.4g\n", run.seconds);
  std::fflush(stdout);
}

bool is_asked_for(const char* name, char** begin, char** end) {
  return begin == end ||
         std::any_of(begin, end, [name](const char* each) { return std::strcmp(each, name) == 0; });
}

int print_help() {
  std::fputs(help, stderr);
  for (const Switch& each : switches) std::fprintf(stderr, " %s", each.name);
  std::fputs("\n", stderr);
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return print_help();
  const int halvings = argc > 2 ? std::atoi(argv[2]) : 0;
  const double limit = argc > 3 ? std::atof(argv[3]) : 100.0;
  const auto robot = parallel_aspects::test::shipped(argv[1])->manipulator();
  MapOptions options;
  parallel_aspects::MapPlan plan;
  make_map_plan(*robot, options, plan);
  if (halvings != 0) options.resolution = std::ldexp(plan.resolution, -halvings);
  options.threads = 1;
  for (const Switch& each : switches) {
    if (!is_asked_for(each.name, argv + std::min(argc, 4), argv + argc)) continue;
    ComponentPolicy policy;
    each.turn_off(policy);
    print(argv[1], halvings, each.name, best_run(robot, options, policy, limit));
  }
}
