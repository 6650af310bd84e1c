// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <array>
#include <chrono>
#include <cstdlib>
#include <random>

namespace parallel_aspects {
namespace {

using Clock = std::chrono::steady_clock;

// More, for a long search: DESCRIPTION_MUTATIONS=100000.
int trials() {
  const char* wanted = std::getenv("DESCRIPTION_MUTATIONS");
  return wanted != nullptr ? std::atoi(wanted) : test::thinned(150);
}

std::string mutated(std::string text, std::mt19937& random) {
  static const std::array<std::string, 16> tokens{
      "nan",       "-1",    "0",         "1e308", "<", ">",  "\"", "continuous",
      "prismatic", "fixed", "base_link", "tool",  "[", ": ", "\n", ""};
  const int changes = 1 + static_cast<int>(random() % 4);
  for (int k = 0; k < changes; ++k) {
    const std::size_t at = random() % text.size(),
                      length = random() % std::min<std::size_t>(40, text.size() - at);
    switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, tokens[random() % tokens.size()]);
        break;
      default:
        text.insert(random() % text.size(), text.substr(at, length));
    }
    if (text.empty()) text = " ";
  }
  return text;
}

// Names and numbers change places more often than letters do.
std::string swapped(const std::string& text, std::mt19937& random) {
  std::vector<std::pair<std::size_t, std::size_t>> quoted;
  for (std::size_t open = text.find('"'); open != std::string::npos;) {
    const std::size_t close = text.find('"', open + 1);
    if (close == std::string::npos) break;
    quoted.emplace_back(open + 1, close - open - 1);
    open = text.find('"', close + 1);
  }
  if (quoted.empty()) return text;
  const auto [from, length] = quoted[random() % quoted.size()];
  const auto [other, other_length] = quoted[random() % quoted.size()];
  std::string result = text;
  return result.replace(from, length, text.substr(other, other_length));
}

class DescriptionMutation : public ::testing::TestWithParam<std::string> {};

// Whatever the texts hold, a mechanism comes back or messages do, in bounded time.
TEST_P(DescriptionMutation, IsLoadedOrRefused) {
  const std::string urdf = test::source_file("urdf/" + GetParam() + ".urdf");
  const std::string config = test::source_file("config/robots/" + GetParam() + ".yaml");
  std::mt19937 random(11);
  for (int trial = 0; trial < trials(); ++trial) {
    std::string bad_urdf = urdf, bad_config = config;
    if (trial % 3 == 0) bad_urdf = mutated(urdf, random);
    if (trial % 3 == 1) bad_config = mutated(config, random);
    if (trial % 3 == 2) bad_urdf = swapped(swapped(urdf, random), random);
    const Clock::time_point start = Clock::now();
    try {
      const auto mechanism = test::load(bad_urdf, bad_config);
      EXPECT_LE(test::open_loops(*mechanism, 0.05), 0) << bad_urdf << bad_config;
    } catch (const InvalidDescription& invalid) {
      for (const std::string& problem : invalid.problems()) EXPECT_FALSE(problem.empty());
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << bad_urdf << bad_config;
    }
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(20)) << bad_urdf << bad_config;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, DescriptionMutation,
                         ::testing::Values("five_bar", "bipod", "three_rrr", "delta", "stewart",
                                           "agile_eye"));

}  // namespace
}  // namespace parallel_aspects
