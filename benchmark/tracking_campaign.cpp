// SPDX-License-Identifier: BSD-3-Clause
//
// Prints a row of the table of docs/development/benchmarks.md for each robot: `tracking_campaign STEPS SEED
// [ROBOT...]`.
#include "support/tracking_campaign.h"

#include "support/robots/shipped.h"
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using parallel_aspects::Ambiguity;
namespace test = parallel_aspects::test;

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "Usage: tracking_campaign STEPS SEED [ROBOT...]\n");
    return 2;
  }
  std::vector<std::string> robots(argv + 3, argv + argc);
  if (robots.empty()) robots.assign(test::campaign_robots.begin(), test::campaign_robots.end());
  long wrong = 0;
  for (const std::string& robot : robots) {
    const auto mechanism = test::shipped(robot);
    const auto seed = static_cast<unsigned>(std::atol(argv[2]));
    const test::CampaignCounts counts = test::TrackingCampaign(*mechanism, seed).run(std::atol(argv[1]));
    const auto told = [&](Ambiguity ambiguity) {
      return counts.ambiguous[static_cast<std::size_t>(ambiguity)];
    };
    std::printf("| %s | %ld | %ld | %ld | %ld | %ld | %ld | %ld / %ld |\n", robot.c_str(), counts.steps,
                counts.wrong, told(Ambiguity::near_parallel_singularity), told(Ambiguity::step_budget),
                counts.avoidable, counts.unjudged, counts.crossings_found, counts.crossings_made);
    if (counts.wrong > 0) std::fprintf(stderr, "%s\n", counts.first_wrong.c_str());
    std::fflush(stdout);
    wrong += counts.wrong;
  }
  return wrong == 0 ? 0 : 1;
}
