// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/faulty_robots.h"
#include "urdf/corrections/said_of_robots.h"

#include <gtest/gtest.h>

#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>

namespace parallel_aspects {
namespace {

using test::are_same;
using test::Description;
using test::FaultyRobot;

enum Outcome : std::size_t { loaded, named, listed, not_found, wrong };
using Counts = std::array<int, 5>;

bool loads(const Description& description) { return test::refusal(description).empty(); }

bool is_of(const std::string& remedy, const FaultyRobot& robot) {
  return remedy.find(robot.element) != std::string::npos;
}

// Every remedy is followed to the letter: all of one sentence together, each of several alone.
Outcome outcome(const FaultyRobot& robot, const Problems& problems, std::string& said) {
  if (problems.empty()) return loaded;
  for (const std::string& problem : problems) said += problem + "\n";
  if (said.find("joint " + robot.element +
                " in mechanism.actuated_joints, but robot.urdf fixes that joint") != std::string::npos)
    return named;
  const std::vector<std::string> remedies = test::remedies(said);
  if (remedies.empty()) return said.find("makes it a robot") == std::string::npos ? not_found : wrong;
  const bool alone = said.find("each of these corrections alone") != std::string::npos;
  const std::vector<Description> corrected = test::followed(robot.text, said);
  if (!std::all_of(corrected.begin(), corrected.end(), loads)) return wrong;
  const auto count = std::count_if(remedies.begin(), remedies.end(),
                                   [&](const std::string& remedy) { return is_of(remedy, robot); });
  const bool is_open = said.find("there may be others") != std::string::npos;
  if (alone && count == 0) return is_open ? not_found : wrong;
  if (alone) return listed;
  return count == static_cast<std::ptrdiff_t>(remedies.size()) ? named : wrong;
}

void print(const std::string& robot, const std::map<std::string, Counts>& table) {
  std::cout << std::left << std::setw(14) << robot << " loads named listed  none wrong\n";
  for (const auto& [kind, counts] : table) {
    std::cout << std::setw(14) << kind << std::right;
    for (const int count : counts) std::cout << std::setw(6) << count;
    std::cout << std::left << '\n';
  }
}

class CorrectionSearch : public ::testing::TestWithParam<std::string> {};

TEST_P(CorrectionSearch, NamesWhatIsAtFault) {
  std::map<std::string, Counts> table;
  const bool is_verbose = std::getenv("CORRECTIONS_VERBOSE") != nullptr;
  double slowest = 0.0;
  const std::vector<FaultyRobot> robots = test::faulty_robots(GetParam());
  const std::size_t step = std::getenv("CORRECTIONS_ALL") != nullptr ? 1 : test::is_sanitized ? 40 : 5;
  for (std::size_t k = 0; k < robots.size(); k += step) {
    const FaultyRobot& robot = robots[k];
    std::string said;
    const std::clock_t start = std::clock();
    const Problems problems = test::refusal(robot.text.urdf, robot.text.config);
    const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    slowest = std::max(slowest, took);
    const Outcome found = outcome(robot, problems, said);
    ++table[robot.kind][found];
    if (is_verbose)
      std::cout << "OUT " << found << ' ' << robot.kind << ' ' << robot.element << ' ' << took
                << " s: " << said << std::endl;
    EXPECT_NE(found, wrong) << robot.kind << " of " << robot.element << ": " << said;
  }
  print(GetParam(), table);
  std::cout << "slowest " << slowest << " s of processor time\n";
}

// Whoever makes a mistake makes it in each leg: what is offered makes the robot that is meant, or one of
// several does, or it is refused without a remedy.
TEST_P(CorrectionSearch, NamesWhatIsAtFaultInAllLegs) {
  std::map<std::string, Counts> table;
  const Description meant = test::shipped_text(GetParam());
  const std::vector<FaultyRobot> robots = test::robots_with_like_faults(GetParam());
  for (std::size_t k = 0; k < robots.size(); k += test::is_sanitized ? 7 : 1) {
    const FaultyRobot& robot = robots[k];
    const Problems problems = test::refusal(robot.text.urdf, robot.text.config);
    std::string said;
    for (const std::string& problem : problems) said += problem + "\n";
    const std::vector<Description> corrected = test::followed(robot.text, said);
    Outcome found = problems.empty() ? loaded : corrected.empty() ? not_found : wrong;
    if (std::all_of(corrected.begin(), corrected.end(), loads) &&
        std::any_of(corrected.begin(), corrected.end(),
                    [&](const Description& one) { return are_same(one, meant); }))
      found = corrected.size() == 1 ? named : listed;
    ++table[robot.kind][found];
    if (std::getenv("CORRECTIONS_VERBOSE") != nullptr)
      std::cout << "OUT " << found << ' ' << robot.kind << ' ' << robot.element << ": " << said << std::endl;
    EXPECT_NE(found, wrong) << robot.kind << " of " << robot.element << ": " << said;
  }
  print(GetParam(), table);
}

INSTANTIATE_TEST_SUITE_P(Robots, CorrectionSearch,
                         ::testing::Values("five_bar", "three_rrr", "three_rpr", "delta", "hexa", "stewart",
                                           "three_prr", "linear_delta", "bipod", "six_pus", "agile_eye",
                                           "spherical_3rrr"));

}  // namespace
}  // namespace parallel_aspects
