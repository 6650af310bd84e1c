// SPDX-License-Identifier: BSD-3-Clause
//
// Paths between random poses of one working mode and one sign of det A, planned three ways in one run:
//   - by this package, in a map or, with six degrees of freedom, over a roadmap;
//   - by OMPL's RRTConnect and its own motions, checked at poses by OMPL's default resolution;
//   - by OMPL's RRTConnect with motions that are proved.
//   ompl_comparison PAIRS SECONDS [ROBOT...]     SECONDS: what RRTConnect may take for one pair
// All times are of the processor, so that other work on the machine counts nothing.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/ompl/aspect_space_information.h"
#include "parallel_aspects/singularity/indices.h"

#include "support/campaign_figures.h"
#include "support/pose_pairs.h"
#include "support/robots/shipped.h"
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Robot = std::shared_ptr<const Manipulator>;

constexpr int looks_at_a_motion = 2000;  // for singularities that a path passes unseen
constexpr double touching = 1e-10;       // of the parallel index, found by search along a motion

struct Question {
  ModeAndSign side;
  Pose from, to;
};

/// What one way made of one question.
struct Answer {
  bool found = false;
  double milliseconds = 0.0;
  double length = 0.0;   // [m], rotations times the characteristic length; [rad] in SO3
  bool crosses = false;  // a pose of it is singular, or out of reach
};

double length_between(const Manipulator& robot, const Pose& from, const Pose& to) {
  return (to.position - from.position).norm() +
         robot.characteristic_length() * from.orientation.angularDistance(to.orientation);
}

/// OMPL's own space, with the bounds and weights of ours.
ob::StateSpacePtr plain_space(const Manipulator& robot) {
  const ob::StateSpacePtr ours = make_pose_state_space(robot);
  const auto with_rotations = [&ours](auto made, auto& same) -> ob::StateSpacePtr {
    made->setBounds(same.getBounds());
    made->setSubspaceWeight(1, same.getSubspaceWeight(1));
    return made;
  };
  if (robot.task_space() == TaskSpace::SE2)
    return with_rotations(std::make_shared<ob::SE2StateSpace>(), *ours->as<ob::SE2StateSpace>());
  if (robot.task_space() == TaskSpace::SE3)
    return with_rotations(std::make_shared<ob::SE3StateSpace>(), *ours->as<ob::SE3StateSpace>());
  if (robot.task_space() == TaskSpace::SO3) return std::make_shared<ob::SO3StateSpace>();
  auto made = std::make_shared<ob::RealVectorStateSpace>(ours->getDimension());
  made->setBounds(ours->as<ob::RealVectorStateSpace>()->getBounds());
  return made;
}

bool is_valid(const Manipulator& robot, const Pose& pose, const ModeAndSign& side) {
  return test::sign_in_doubles(robot, pose, side.mode) == side.determinant_sign;
}

/// As its users set it up: a state is valid where the legs reach and det A has the sign, by plain arithmetic.
ob::SpaceInformationPtr sampled_information(const Robot& robot, const ModeAndSign& side) {
  auto information = std::make_shared<ob::SpaceInformation>(plain_space(*robot));
  information->setStateValidityChecker([robot, side](const ob::State* state) {
    return is_valid(*robot, pose_of(robot->task_space(), *state), side);
  });
  information->setup();
  return information;
}

/// One motion of a path, as OMPL interpolates it.
class Motion {
 public:
  Motion(const Manipulator& robot, const Question& question, const og::PathGeometric& path, unsigned k)
      : robot_(robot),
        side_(question.side),
        space_(path.getSpaceInformation()->getStateSpace()),
        from_(path.getState(k)),
        to_(path.getState(k + 1)),
        state_(space_) {}

  /// Whether some pose is out of reach, or has another sign of det A, or det A touches zero there.
  bool crosses() {
    std::array<double, 3> last{1.0, 1.0, 1.0};
    for (int i = 0; i <= looks_at_a_motion; ++i) {
      last = {last[1], last[2], index(i * step)};
      if (last[2] < 0.0) return true;
      if (last[1] <= last[0] && last[1] <= last[2] && least_between((i - 2) * step, i * step) < touching)
        return true;
    }
    return false;
  }

 private:
  static constexpr double step = 1.0 / looks_at_a_motion;

  /// The parallel index, or a negative number where the state is not valid.
  double index(double t) {
    space_->interpolate(from_, to_, std::clamp(t, 0.0, 1.0), state_.get());
    const Pose pose = pose_of(robot_.task_space(), *state_);
    if (!is_valid(robot_, pose, side_)) return -1.0;
    return parallel_index(robot_, pose, inverse(robot_, pose, side_.mode).q);
  }

  /// By thirds.
  double least_between(double begin, double end) {
    for (int i = 0; i < 80; ++i) {
      const double third = (end - begin) / 3.0;
      if (index(begin + third) < index(end - third))
        end -= third;
      else
        begin += third;
    }
    return index(begin);
  }

  const Manipulator& robot_;
  const ModeAndSign side_;
  const ob::StateSpacePtr space_;
  const ob::State *from_, *to_;
  ob::ScopedState<> state_;
};

bool crosses(const Manipulator& robot, const Question& question, const og::PathGeometric& path) {
  for (unsigned k = 0; k + 1 < path.getStateCount(); ++k)
    if (Motion(robot, question, path, k).crosses()) return true;
  return false;
}

double length_of(const Manipulator& robot, const og::PathGeometric& path) {
  double length = 0.0;
  for (unsigned k = 0; k + 1 < path.getStateCount(); ++k)
    length += length_between(robot, pose_of(robot.task_space(), *path.getState(k)),
                             pose_of(robot.task_space(), *path.getState(k + 1)));
  return length;
}

Answer by_ompl(const Robot& robot, const Question& question, const ob::SpaceInformationPtr& information,
               double seconds) {
  og::SimpleSetup setup(information);
  setup.setPlanner(std::make_shared<og::RRTConnect>(information));
  ob::ScopedState<> from(information), to(information);
  set_pose(robot->task_space(), question.from, *from);
  set_pose(robot->task_space(), question.to, *to);
  setup.setStartAndGoalStates(from, to);
  Answer answer;
  const test::Stopwatch stopwatch;
  const ob::PlannerTerminationCondition is_over(
      [&stopwatch, seconds] { return stopwatch.seconds() > seconds; });
  if (setup.solve(is_over) == ob::PlannerStatus::EXACT_SOLUTION) {
    setup.simplifySolution();
    answer.found = setup.getSolutionPath().check();  // by the same means as the planner
  }
  answer.milliseconds = 1e3 * stopwatch.seconds();
  if (!answer.found) return answer;
  answer.length = length_of(*robot, setup.getSolutionPath());
  answer.crosses = crosses(*robot, question, setup.getSolutionPath());
  return answer;
}

/// Plans by this package.
using Planner = std::function<PlannedPath(const PathEnd&, const PathEnd&)>;

std::optional<Planner> planner_of(const Robot& robot) {
  if (robot->task_space() == TaskSpace::SE3) {
    const auto roadmap = compute_pose_roadmap(robot).roadmap;
    if (!roadmap) return std::nullopt;
    return [roadmap](const PathEnd& from, const PathEnd& to) { return plan_in_roadmap(*roadmap, from, to); };
  }
  const auto map = compute_aspect_map(robot).map;
  if (!map) return std::nullopt;
  auto planner = std::make_shared<PathPlanner>(map);
  return
      [planner](const PathEnd& from, const PathEnd& to) { return planner->plan(from, to, PathPolicy::stay); };
}

/// What became of all questions about one robot.
class Comparison {
 public:
  Comparison(Robot robot, Planner planner, double seconds)
      : robot_(std::move(robot)), planner_(std::move(planner)), seconds_(seconds) {}

  void ask(const Question& question) {
    const PathEnd from{question.from, question.side.mode}, to{question.to, question.side.mode};
    const test::Stopwatch stopwatch;
    const PlannedPath planned = planner_(from, to);
    ++questions_;
    ours_.milliseconds.push_back(1e3 * stopwatch.seconds());
    no_ += planned.answer == SameAspect::no ? 1 : 0;
    const double length = planned.length + robot_->characteristic_length() * planned.turned;
    if (planned) ++ours_.found;
    const double shortest = planned ? length : 0.0;
    take(by_ompl(robot_, question, sampled_information(robot_, question.side), seconds_), shortest, sampled_);
    take(by_ompl(robot_, question, make_aspect_space_information(robot_, question.side), seconds_), shortest,
         certified_);
  }

  void print() const {
    std::printf("| %s | %d | %d | %d | %.1f / %.1f ", robot_->name().c_str(), questions_, ours_.found, no_,
                test::quantile(ours_.milliseconds, 0.5), test::quantile(ours_.milliseconds, 0.95));
    for (const Row* row : {&sampled_, &certified_})
      std::printf("| %d | %.1f / %.1f | %.2f | %d ", row->found, test::quantile(row->milliseconds, 0.5),
                  test::quantile(row->milliseconds, 0.95), test::quantile(row->lengths, 0.5), row->crossing);
    std::printf("|\n");
    std::fflush(stdout);
  }

 private:
  struct Row {
    int found = 0, crossing = 0;
    std::vector<double> milliseconds;
    std::vector<double> lengths;  // relative to ours, where ours has a path
  };

  static void take(const Answer& answer, double our_length, Row& row) {
    row.milliseconds.push_back(answer.milliseconds);
    if (!answer.found) return;
    ++row.found;
    row.crossing += answer.crosses ? 1 : 0;
    if (our_length > 0.0) row.lengths.push_back(answer.length / our_length);
  }

  const Robot robot_;
  const Planner planner_;
  const double seconds_;
  int questions_ = 0, no_ = 0;
  Row ours_, sampled_, certified_;
};

std::optional<Question> draw(const Robot& robot, test::PosePairs& pairs) {
  const WorkingMode mode = pairs.mode();
  const auto from = pairs.reached(mode), to = pairs.reached(mode);
  if (!from || !to) return std::nullopt;
  const int sign = test::sign_in_doubles(*robot, *from, mode);
  if (sign != test::sign_in_doubles(*robot, *to, mode)) return std::nullopt;
  return Question{{mode, sign}, *from, *to};
}

void compare(const std::string& name, int count, double seconds) {
  const Robot robot = test::shipped(name)->manipulator();
  const auto planner = planner_of(robot);
  if (!planner) return;
  Comparison comparison(robot, *planner, seconds);
  test::PosePairs pairs(robot, 1);
  for (int i = 0; i < count;)
    if (const auto question = draw(robot, pairs)) {
      comparison.ask(*question);
      ++i;
    }
  comparison.print();
}

}  // namespace
}  // namespace parallel_aspects

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "ompl_comparison PAIRS SECONDS [ROBOT...]\n");
    return EXIT_FAILURE;
  }
  std::vector<std::string> robots(argv + 3, argv + argc);
  if (robots.empty())
    robots = {"bipod",        "five_bar",  "three_prr",      "three_rpr", "three_rrr", "delta",
              "linear_delta", "agile_eye", "spherical_3rrr", "hexa",      "six_pus",   "stewart"};
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
  std::printf(
      "robot, pairs | ours: yes, no, ms median / p95 | sampled: found, ms, length, crossing | proved\n");
  for (const std::string& robot : robots)
    parallel_aspects::compare(robot, std::atoi(argv[1]), std::atof(argv[2]));
}
