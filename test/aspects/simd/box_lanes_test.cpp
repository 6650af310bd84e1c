// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_intervals.h"
#include "aspects/map/map_contents.h"
#include "aspects/simd/box_requests.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <dlfcn.h>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr InstructionSet all_instructions[] = {InstructionSet::sse2, InstructionSet::avx2};

using Robot = std::shared_ptr<const Manipulator>;

/// The same robot with each actuated joint limited to a part of what it reaches.
Robot limited(const Manipulator& robot, std::mt19937_64& random) {
  ManipulatorDescription description = robot.description();
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (Leg& leg : description.legs) {
    const bool is_length = leg.kind().type == LegType::strut || leg.kind().type == LegType::prismatic;
    const double scale = is_length ? robot.size() : EIGEN_PI;
    const double lower = scale * (share(random) - (leg.kind().type == LegType::strut ? 0.0 : 0.8));
    leg.limits = {lower, lower + scale * (0.2 + 1.5 * share(random))};
  }
  return std::make_shared<const Manipulator>(description);
}

std::vector<Robot> robots() {
  std::vector<Robot> all{test::five_bar(),  test::bipod(),
                         test::three_rpr(), test::three_rrr(),
                         test::three_prr(), test::three_rrr_actuated_elbow(),
                         test::delta(),     test::linear_delta(),
                         test::agile_eye(), test::spherical_three_rrr()};
  std::mt19937_64 random(20261125);
  const std::size_t unlimited = all.size();
  for (std::size_t i = 0; i < unlimited; ++i)
    for (int k = 0; k < 2; ++k) all.push_back(limited(*all[i], random));
  return all;
}

/// Boxes of one robot, in no order, some of them halves of each other's neighbours.
class RandomBoxes {
 public:
  explicit RandomBoxes(const Manipulator& robot, const BoxClassifier& classifier) {
    Box positions{robot.task_space() == TaskSpace::T3 ? 3U : 2U, {-3.0, -3.0, -3.0}, {3.0, 3.0, 3.0}};
    if (const auto reachable = classifier.reachable_positions(); reachable && reachable->dimension > 0)
      positions = *reachable;
    space_ = make_pose_space(robot.task_space(), positions, robot.characteristic_length());
  }

  BoxRequest next(std::size_t modes, std::vector<LeafState>& states) {
    const Box& region = space_->region();
    BoxRequest request{static_cast<RootIndex>(random_() % space_->root_count()), region, 0, states.data()};
    const double share = std::pow(2.0, uniform(-12.0, -2.0));
    for (std::size_t i = 0; i < region.dimension; ++i) {
      const double width = share * region.width(i);
      request.box.lower[i] = uniform(region.lower[i], region.upper[i] - width);
      request.box.upper[i] = request.box.lower[i] + width;
      if (random_() % 8 == 0) request.box.upper[i] = request.box.lower[i];  // flat, as a face
    }
    while (request.modes == 0) request.modes = random_() & ((ModeSet{1} << modes) - 1);
    return request;
  }

 private:
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random_);
  }

  std::shared_ptr<const PoseSpace> space_;
  std::mt19937_64 random_{20261126};
};

std::string text(const Manipulator& robot, const BoxRequest& request) {
  std::string result = robot.name() + ", root " + std::to_string(request.root) + ", box";
  char number[64];
  for (std::size_t i = 0; i < request.box.dimension; ++i) {
    std::snprintf(number, sizeof number, " %a to %a", request.box.lower[i], request.box.upper[i]);
    result += number;
  }
  return result;
}

// One by one every number is worked out by `Interval` and by `Affine` of double.
TEST(BoxLanes, FindOfEachBoxWhatIsFoundOfItAlone) {
  std::size_t compared = 0, undecided = 0;
  for (const Robot& robot : robots()) {
    const std::vector<WorkingMode> modes = working_modes(*robot);
    BoxPolicy without_shells;
    without_shells.shells = false;
    for (const auto& [detail, policy] :
         {std::pair(Detail::states, BoxPolicy()), std::pair(Detail::centers, BoxPolicy()),
          std::pair(Detail::parts, BoxPolicy()), std::pair(Detail::parts, without_shells),
          std::pair(Detail::all_parts, BoxPolicy())}) {
      const auto classifier = make_box_classifier(*robot, modes, policy);
      RandomBoxes boxes(*robot, *classifier);
      const auto count = static_cast<std::size_t>(test::thinned(120));
      std::vector<std::vector<LeafState>> one(count, std::vector<LeafState>(modes.size())), other = one;
      BoxRequests requests, again;
      for (std::size_t i = 0; i < count; ++i) {
        requests.push_back(boxes.next(modes.size(), one[i]));
        again.push_back(requests.back());
        again.back().states = other[i].data();
      }
      const RoundingUpward rounding;
      classify(*classifier, requests, detail, InstructionSet::none);
      for (const InstructionSet instructions : all_instructions) {
        if (!has_instructions(instructions)) continue;
        for (auto& states : other) std::fill(states.begin(), states.end(), LeafState());
        classify(*classifier, again, detail, instructions);
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t mode = 0; mode < modes.size(); ++mode) {
            ASSERT_EQ(one[i][mode].code(), other[i][mode].code())
                << text(*robot, requests[i]) << ", mode " << mode << ", set " << int(instructions);
            ++compared;
            undecided += one[i][mode].is_undecided();
          }
      }
    }
  }
  EXPECT_GT(compared, 10U * undecided / 9U);
  EXPECT_GT(undecided, compared / 50U);
}

// What is told of a box at a time decides how many boxes of which state are examined again on their faces.
TEST(BoxLanes, FindThePartsThatAreFoundInEachBoxAlone) {
  std::map<Part::Kind, std::size_t> found;
  for (const Robot& robot : robots()) {
    const std::vector<WorkingMode> modes = working_modes(*robot);
    const auto classifier = make_box_classifier(*robot, modes);
    RandomBoxes boxes(*robot, *classifier);
    std::vector<LeafState> states(modes.size());
    for (int round = 0; round < test::thinned(10); ++round) {
      const auto mode = static_cast<std::size_t>(round) % modes.size();
      const int sign = round % 3 == 0 ? -1 : 1;
      std::vector<SharedFace> faces;
      for (int i = 0; i < 20; ++i) {
        const BoxRequest request = boxes.next(modes.size(), states);
        faces.push_back({request.root, request.box});
      }
      const RoundingUpward rounding;
      for (const InstructionSet instructions : all_instructions) {
        if (!has_instructions(instructions)) continue;
        const std::vector<Part> parts = find_parts(*classifier, mode, sign, faces, instructions);
        ASSERT_EQ(parts.size(), faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i) {
          const Part alone = find_part(*classifier, mode, sign, faces[i].root, faces[i].box);
          const BoxRequest request{faces[i].root, faces[i].box, 0, nullptr};
          ASSERT_EQ(alone.kind, parts[i].kind) << text(*robot, request) << ", mode " << mode;
          ASSERT_EQ(alone.pose, parts[i].pose) << text(*robot, request) << ", mode " << mode;
          ++found[alone.kind];
        }
      }
    }
  }
  for (const Part::Kind kind : {Part::Kind::empty, Part::Kind::connected, Part::Kind::unknown})
    EXPECT_GT(found[kind], static_cast<std::size_t>(test::thinned(100)));
}

bool same(const Interval& a, const Interval& b) { return a.lower() == b.lower() && a.upper() == b.upper(); }

TEST(BoxLanes, BoundTheIndexOfEachBoxAsItIsBoundedAlone) {
  std::size_t compared = 0, between = 0;
  for (const Robot& robot : robots()) {
    const std::vector<WorkingMode> modes = working_modes(*robot);
    const auto classifier = make_box_classifier(*robot, modes);
    RandomBoxes boxes(*robot, *classifier);
    std::vector<LeafState> states(modes.size());
    for (int round = 0; round < test::thinned(20); ++round) {
      const auto mode = static_cast<std::size_t>(round) % modes.size();
      const int sign = round % 3 == 0 ? -1 : 1;
      const ParallelIndex index = round % 2 == 0 ? ParallelIndex::normalised : ParallelIndex::determinant;
      std::vector<IndexRequest> requests;
      for (int i = 0; i < 20; ++i) {
        const BoxRequest request = boxes.next(modes.size(), states);
        requests.push_back({request.root, request.box, i % 4 == 0 ? 1.0 : i % 4 == 1 ? 1e-9 : 0.02});
      }
      const RoundingUpward rounding;
      for (const InstructionSet instructions : all_instructions) {
        if (!has_instructions(instructions)) continue;
        const auto found = enclose_index(*classifier, mode, sign, index, requests, instructions);
        ASSERT_EQ(found.size(), requests.size());
        for (std::size_t i = 0; i < requests.size(); ++i) {
          const auto& [root, box, share] = requests[i];
          const Interval alone = classifier->enclose_index(root, box, mode, sign, index, share);
          ASSERT_TRUE(same(alone, found[i]))
              << text(*robot, {root, box, 0, nullptr}) << ", mode " << mode << ": " << alone.lower() << " to "
              << alone.upper() << ", " << found[i].lower() << " to " << found[i].upper();
          ++compared;
          between += alone.upper() > 0.0 && alone.upper() < every_index(index).upper();
        }
      }
    }
  }
  EXPECT_GT(between, compared / 20U);
}

/// How many leaves of each level there are in each working mode and state.
std::map<std::tuple<std::size_t, std::uint32_t, int>, std::size_t> leaf_counts(const AspectMap& map) {
  const PoseTree& tree = map.contents().tree;
  std::map<std::tuple<std::size_t, std::uint32_t, int>, std::size_t> counts;
  for (NodeIndex node = 0; node < tree.node_count(); ++node)
    for (std::size_t mode = 0; mode < tree.mode_count(); ++mode)
      if (tree.state(node, mode).is_leaf())
        ++counts[{mode, tree.place(node).level, tree.state(node, mode).code()}];
  return counts;
}

void expect_same(const AspectMap& one, const AspectMap& other) {
  EXPECT_EQ(leaf_counts(one), leaf_counts(other));
  EXPECT_EQ(one.proved_count(), other.proved_count());
  EXPECT_EQ(one.unresolved(), other.unresolved());
  EXPECT_EQ(one.indeterminate_leaves(), other.indeterminate_leaves());
  EXPECT_EQ(one.measure_undecided(), other.measure_undecided());
  ASSERT_EQ(one.aspects().size(), other.aspects().size());
  for (std::size_t i = 0; i < one.aspects().size(); ++i) {
    EXPECT_EQ(one.aspects()[i].inside_leaves, other.aspects()[i].inside_leaves);
    EXPECT_EQ(one.aspects()[i].measure_lower, other.aspects()[i].measure_lower);
    EXPECT_EQ(one.aspects()[i].measure, other.aspects()[i].measure);
    EXPECT_EQ(one.aspects()[i].measure_upper, other.aspects()[i].measure_upper);
  }
}

TEST(BoxLanes, MapsAreTheSameByEveryInstructionSetAndNumberOfThreads) {
  const std::pair<const char*, double> cases[] = {
      {"five_bar", 0.2}, {"three_prr", 0.0491}, {"linear_delta", 0.012}};
  for (const auto& [name, resolution] : cases) {
    const auto robot = test::shipped(name)->manipulator();
    MapOptions options;
    options.resolution = resolution;
    options.threads = 1;
    use_instructions(InstructionSet::none);
    const MapResult alone = compute_aspect_map(robot, options);
    ASSERT_TRUE(alone) << alone.message;
    for (const InstructionSet instructions : all_instructions)
      for (const unsigned threads : {1U, 2U}) {
        if (!has_instructions(instructions)) continue;
        SCOPED_TRACE(std::string(name) + ", set " + std::to_string(int(instructions)));
        use_instructions(instructions);
        options.threads = threads;
        const MapResult found = compute_aspect_map(robot, options);
        ASSERT_TRUE(found) << found.message;
        expect_same(*alone.map, *found.map);
      }
  }
  use_instructions(widest_instructions());
}

/// The functions of a file of the program whose disassembly matches, by their names.
std::vector<std::string> functions_with(const std::string& file, const std::string& pattern) {
  const std::string command = "objdump --disassemble --demangle --no-show-raw-insn '" + file +
                              "' 2> /dev/null | awk '/^[0-9a-f]+ </ { name = $0 } /" + pattern +
                              "/ && name != last { print name; last = name }'";
  std::vector<std::string> names;
  FILE* pipe = popen(command.c_str(), "r");
  char line[4096];
  while (pipe != nullptr && std::fgets(line, sizeof line, pipe) != nullptr) names.emplace_back(line);
  if (pipe != nullptr) pclose(pipe);
  return names;
}

bool is_of_lanes(const std::string& name) {
  return name.find("LaneCode<double __vector(4)>::run<") != std::string::npos;
}

// Whatever else were compiled for wide vectors could be an inline function that the linker takes for the
// whole program, which then ends on a processor without them.
TEST(BoxLanes, WideVectorsAreUsedByFunctionsOfTheirOwnAlone) {
  Dl_info info;
  if (!has_instructions(InstructionSet::avx2) || test::is_sanitized ||
      dladdr(reinterpret_cast<void*>(&widest_instructions), &info) == 0)
    GTEST_SKIP() << "nothing is compiled for them here";
  const std::vector<std::string> wide = functions_with(info.dli_fname, "%[yz]mm");
  if (wide.empty()) GTEST_SKIP() << "objdump told nothing of " << info.dli_fname;
  EXPECT_TRUE(std::any_of(wide.begin(), wide.end(), is_of_lanes)) << "nothing is compiled for four lanes";
  for (const std::string& name : wide)
    EXPECT_TRUE(is_of_lanes(name) || name.find("[clone .arch_") != std::string::npos) << name;
  for (const std::string& name : functions_with(info.dli_fname, "vfn?m(add|sub)"))
    EXPECT_FALSE(is_of_lanes(name)) << "a product and a sum in one are rounded once: " << name;
}

}  // namespace
}  // namespace parallel_aspects
