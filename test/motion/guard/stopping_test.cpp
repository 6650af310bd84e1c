// SPDX-License-Identifier: BSD-3-Clause
#include "motion/guard/issued_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

// Integrated in small steps: the command for a while, then down to zero; what the robot is faster by is lost
// at the same time.
double integrated(const StoppingMotion& motion, double scale) {
  constexpr int steps = 20000;
  const double end = motion.seconds + motion.brake + motion.last_brake;
  double travel = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps * end;
    double speed = scale * motion.speed;
    if (t > motion.seconds)
      speed =
          motion.brake > 0.0
              ? std::max(0.0, scale * motion.speed * (1.0 - (t - motion.seconds) / (scale * motion.brake)))
              : 0.0;
    if (t < motion.last_brake)
      speed += std::max(0.0, motion.last - scale * motion.speed) * (1.0 - t / motion.last_brake);
    travel += speed * end / steps;
  }
  return travel;
}

TEST(StoppingMotion, TravelsWhatIntegrationSays) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.01, 1.0);
  for (int i = 0; i < 100; ++i) {
    const StoppingMotion motion{uniform(random), uniform(random), uniform(random), uniform(random),
                                uniform(random)};
    const double scale = uniform(random);
    EXPECT_NEAR(motion.travel(scale), integrated(motion, scale), 1e-3)
        << "{" << motion.speed << ", " << motion.seconds << ", " << motion.brake << ", " << motion.last
        << ", " << motion.last_brake << "}, " << scale;
  }
}

TEST(StoppingMotion, LargestScaleIsThatOfATry) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int tries = 20000;
  for (int i = 0; i < 300; ++i) {
    const StoppingMotion motion{uniform(random), 0.5 * uniform(random), i % 7 == 0 ? 0.0 : uniform(random),
                                i % 5 == 0 ? 0.0 : uniform(random), uniform(random)};
    const double room = uniform(random) - 0.1;
    double best = 0.0;
    for (int k = 0; k <= tries && motion.travel(static_cast<double>(k) / tries) <= room; ++k)
      best = static_cast<double>(k) / tries;
    const double found = motion.largest_scale(room);
    EXPECT_NEAR(found, best, 1.5 / tries)
        << "{" << motion.speed << ", " << motion.seconds << ", " << motion.brake << ", " << motion.last
        << ", " << motion.last_brake << "}, " << room;
    EXPECT_TRUE(found == 0.0 || motion.travel(found) <= room * (1.0 + 1e-8)) << i;
  }
}

}  // namespace
}  // namespace parallel_aspects
