// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a row of the table of docs/development/benchmarks.md for each robot and kind of hazard:
// `stopping_campaign RUNS SEED [speed=SPEED] [noise=NOISE] [ROBOT...]`, with one speed [sizes of the robot a
// second] and one noise [rad or sizes] where they are stated.
#include "ros/monitor/stopping_campaign.h"

#include "support/robots/shipped.h"
#include "support/tracking_campaign.h"
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using parallel_aspects::Hazard;
namespace test = parallel_aspects::test;

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "Usage: stopping_campaign RUNS SEED [speed=SPEED] [noise=NOISE] [ROBOT...]\n");
    return 2;
  }
  test::StoppingPlan plan;
  plan.runs = std::atoi(argv[1]);
  std::vector<std::string> robots;
  for (int i = 3; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("speed=", 0) == 0)
      plan.speeds = {std::atof(argv[i] + 6)};
    else if (argument.rfind("noise=", 0) == 0)
      plan.noises = {std::atof(argv[i] + 6)};
    else
      robots.push_back(argument);
  }
  if (robots.empty()) robots.assign(test::campaign_robots.begin(), test::campaign_robots.end());
  long failures = 0;
  for (const std::string& robot : robots)
    for (const Hazard hazard : {Hazard::parallel_singularity, Hazard::serial_singularity, Hazard::limit}) {
      test::StoppingCampaign campaign(test::shipped(robot), plan, std::strtoull(argv[2], nullptr, 10));
      const test::StoppingCounts counts = campaign.run(hazard);
      if (counts.runs == 0) continue;
      std::printf("| %s | %s | %ld | %ld | %ld | %.2f | %.1e | %ld | %.2f |\n", robot.c_str(), name(hazard),
                  counts.runs, counts.lost, counts.too_near, counts.inside, counts.pose_error, counts.passed,
                  counts.left);
      std::fflush(stdout);
      failures += counts.too_near + counts.passed;
      if (!counts.first_failure.empty()) std::fprintf(stderr, "%s\n", counts.first_failure.c_str());
    }
  return failures == 0 ? 0 : 1;
}
