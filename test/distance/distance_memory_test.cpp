// SPDX-License-Identifier: BSD-3-Clause
// A meter takes its memory when it is made, and throws nothing later.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/distance/boundary_distances.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace {

thread_local std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace parallel_aspects {
namespace {

static_assert(noexcept(std::declval<BoundaryDistanceMeter&>().measure(std::declval<const Pose&>(),
                                                                      std::declval<const WorkingMode&>())));

TEST(NoAllocation, HookCounts) {
  const std::size_t before = allocations;
  std::vector<double> numbers(100);
  numbers.push_back(1.0);
  EXPECT_GT(allocations, before);
}

void expect_no_allocation(const std::shared_ptr<const Manipulator>& robot, BoundaryDistanceMeter& meter) {
  test::PosePairs random(robot, 20261121);
  for (int i = 0; i < 5; ++i) {
    const WorkingMode mode = random.mode();
    const auto pose = random.reached(mode);
    ASSERT_TRUE(pose) << robot->name();
    const std::size_t before = allocations;
    const BoundaryDistances distances = meter.measure(*pose, mode);
    EXPECT_EQ(allocations, before) << robot->name();
    EXPECT_NE(distances.status, ConfigurationStatus::invalid) << robot->name();
  }
}

TEST(NoAllocation, MeasuringTakesNoMemory) {
  for (const auto& robot : {test::five_bar(), test::bipod(), test::three_rpr(), test::three_rrr(),
                            test::delta(), test::agile_eye(), test::stewart(), test::hexa()}) {
    BoundaryDistanceMeter meter(robot);
    expect_no_allocation(robot, meter);
  }
}

TEST(NoAllocation, NorDoesMeasuringWithAMap) {
  for (const auto& robot : {test::five_bar(), test::three_rpr(), test::delta(), test::agile_eye()}) {
    MapOptions options;
    options.resolution = robot->task_space() == TaskSpace::SO3 ? 0.5 : 0.04 * robot->size();
    options.extra_levels = 0;
    BoundaryDistanceMeter meter(robot);
    meter.use(std::make_shared<const DistanceMap>(compute_aspect_map(robot, options).map));
    expect_no_allocation(robot, meter);
  }
}

}  // namespace
}  // namespace parallel_aspects
