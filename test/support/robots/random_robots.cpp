// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/random_robots.h"

#include <Eigen/Geometry>

#include <utility>

namespace parallel_aspects::test {

Eigen::Vector3d RandomRobots::vector(bool planar) {
  const double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0), z = uniform(-1.0, 1.0);
  return {x, y, planar ? 0.0 : z};
}

Eigen::Quaterniond RandomRobots::orientation() {
  std::normal_distribution<double> normal;
  const double x = normal(engine_), y = normal(engine_), z = normal(engine_), w = normal(engine_);
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

Pose RandomRobots::pose(const Motions& motions, double spread) {
  const TaskSpace space = motions.space;
  if (has_hinges(space)) {
    PoseCoordinates angles(static_cast<Eigen::Index>(degrees_of_freedom(space)));
    for (Eigen::Index i = 0; i < angles.size(); ++i) angles[i] = uniform(-EIGEN_PI, EIGEN_PI);
    return pose_from_coordinates(motions, angles).value();
  }
  Pose result;
  if (has_translation(space)) result.position = spread * vector(is_planar(space));
  if (space == TaskSpace::T1) result.position.y() = 0.0;
  if (space == TaskSpace::SE2)
    result.orientation = Eigen::AngleAxisd(uniform(-EIGEN_PI, EIGEN_PI), Eigen::Vector3d::UnitZ());
  if (space == TaskSpace::SO3 || space == TaskSpace::SE3) result.orientation = orientation();
  return result;
}

Actuation RandomRobots::actuation(ActuationKind kind, bool planar) {
  const Eigen::Vector3d axis = planar ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(vector().normalized());
  switch (kind) {
    case ActuationKind::revolute:
      return RevoluteActuation{vector(planar), axis, axis.unitOrthogonal(), uniform(0.5, 1.5)};
    case ActuationKind::prismatic:
      return PrismaticActuation{vector(planar), vector(planar).normalized()};
    case ActuationKind::strut:
      return StrutActuation{vector(planar), uniform(0.0, 0.5), sense()};
    case ActuationKind::elbow:
      return ElbowActuation{vector(planar), uniform(0.5, 1.5), uniform(0.5, 1.5), uniform(-3.0, 3.0),
                            sense()};
  }
  return StrutActuation{vector(planar)};
}

std::shared_ptr<const Manipulator> RandomRobots::robot(TaskSpace space, ActuationKind kind) {
  const bool planar = is_planar(space);
  std::vector<Leg> legs;
  for (std::size_t j = 0; j < degrees_of_freedom(space); ++j) {
    legs.push_back(named_leg(j));
    legs[j].actuation = actuation(kind, planar);
    legs[j].anchor = vector(planar);
    legs[j].rod_length = uniform(0.8, 2.0);
  }
  HingePair hinges;
  if (space == TaskSpace::R2) hinges = {uniform(-0.5, 0.5), uniform(0.3, 2.8)};
  return manipulator("random " + std::string(name(space)), space, std::move(legs), hinges);
}

bool RandomRobots::is_planar(TaskSpace space) {
  return space == TaskSpace::T1 || space == TaskSpace::T2 || space == TaskSpace::SE2;
}

std::shared_ptr<const Manipulator> bounded_robot(unsigned seed, TaskSpace space, bool limited) {
  RandomRobots random(seed);
  ManipulatorDescription description = random.robot(space, all_actuation_kinds[seed % 3])->description();
  WorkspaceBox box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double middle = random.uniform(-0.7, 0.7), half = random.uniform(0.2, 1.2);
    box.lower[i] = middle - half;
    box.upper[i] = middle + half;
  }
  description.constraints.workspace = box;
  for (Leg& leg : description.legs) {
    if (!limited || random.uniform(0.0, 1.0) >= 0.7) continue;
    const double middle = random.uniform(-2.0, 2.0), half = random.uniform(0.3, 1.5);
    const bool is_strut = leg.kind().type == LegType::strut;
    leg.limits =
        is_strut ? JointLimits{0.5 * half, 0.5 * half + 1.0} : JointLimits{middle - half, middle + half};
  }
  return std::make_shared<const Manipulator>(description);
}

}  // namespace parallel_aspects::test
