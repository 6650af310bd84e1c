// SPDX-License-Identifier: BSD-3-Clause
// Tracks a robot from its actuated joints, as a controller would: track_joints URDF YAML
#include <parallel_aspects/model/problems.h>
#include <parallel_aspects/tracking/tracker.h>
#include <parallel_aspects/urdf/mechanism.h>

#include <cstdlib>
#include <iostream>

namespace {

// What a controller of ros_control keeps. `start` belongs into starting(), `update` into update(): it takes
// some microseconds, asks for no memory, takes no lock and throws nothing.
class AspectGuard {
 public:
  explicit AspectGuard(const parallel_aspects::Mechanism& mechanism) : tracker_(mechanism.manipulator()) {}

  bool start(double time, const parallel_aspects::JointVector& q, const parallel_aspects::Pose& pose) {
    return tracker_.start_near(time, q, pose, 1e-3);
  }

  // False where the controller must stop: it is not known where the platform is, or it has changed its
  // working mode.
  bool update(double time, const parallel_aspects::JointVector& q) noexcept {
    tracker_.update(time, q);
    for (const parallel_aspects::Transition& each : tracker_.transitions())
      if (each.kind == parallel_aspects::TransitionKind::working_mode) return false;
    return tracker_.state().followed();
  }

  const parallel_aspects::TrackedState& state() const noexcept { return tracker_.state(); }

 private:
  parallel_aspects::Tracker tracker_;
};

// A second at 1 kHz: the first actuated joint turns until a working mode changes or the assembly mode is not
// known.
int run(char** argv) {
  const auto mechanism = parallel_aspects::load_mechanism_files(argv[1], argv[2]);
  const parallel_aspects::AssembledConfiguration home = mechanism->assembled();
  AspectGuard guard(*mechanism);
  if (!guard.start(0.0, home.q, home.pose)) return EXIT_FAILURE;
  parallel_aspects::JointVector q = home.q;
  int sample = 1;
  for (bool goes_on = true; goes_on && sample <= 1000; ++sample) {
    q[0] += 1e-3;
    goes_on = guard.update(1e-3 * sample, q);
  }
  const parallel_aspects::TrackedState& state = guard.state();
  std::cout << name(state.status) << " after " << sample - 1 << " samples, working mode "
            << to_string(state.mode) << '\n';
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: track_joints URDF YAML\n";
    return EXIT_FAILURE;
  }
  try {
    return run(argv);
  } catch (const parallel_aspects::InvalidDescription& invalid) {
    std::cerr << invalid.what() << '\n';  // every problem, a line each
    return EXIT_FAILURE;
  }
}
