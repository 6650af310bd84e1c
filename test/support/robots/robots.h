// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_H

#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects::test {

using Points = std::vector<Eigen::Vector3d>;

Leg named_leg(std::size_t index);

std::shared_ptr<const Manipulator> manipulator(const std::string& name, TaskSpace space,
                                               std::vector<Leg> legs, const HingePair& hinges = {});

Leg planar_revolute_leg(std::size_t index, const Eigen::Vector2d& center, double crank, double rod,
                        const Eigen::Vector2d& anchor = Eigen::Vector2d::Zero());

std::vector<Leg> struts(const Points& base, const Points& anchors);

/// `radius` (cos angle, sin angle, 0) for each angle [deg].
Points on_circle(double radius, const std::vector<double>& degrees);

/// The paper's five-bar RR-RRR: A=(0,0), B=(9,0); leg 1: crank 8, rod 5; leg 2: crank 5, rod 8.
std::shared_ptr<const Manipulator> five_bar();

std::shared_ptr<const Manipulator> limited_five_bar();

/// A four-bar as a robot of R1: the rocker turns about the origin; the crank at (0.4, 0) unless told
/// otherwise.
std::shared_ptr<const Manipulator> four_bar(double rocker = 0.25, double base = 0.4, double crank = 0.3,
                                            double rod = 0.35);

/// An ankle: pitch about y at the origin, roll about x 0.016 m below it; cranks about -y in the shank.
std::shared_ptr<const Manipulator> ankle();

/// A robot of R1 or R2 on cranks with its base turned about the first hinge, so that other poses lie at half
/// a turn: theta or theta1 is larger by `angle`.
std::shared_ptr<const Manipulator> turned_about_first_hinge(const Manipulator& robot, double angle);

/// Bipod 2-RPR with base points (0,0) and (5,0) and struts limited to [2,6] and [4,9].
std::shared_ptr<const Manipulator> bipod();

/// 3-RPR of Innocenti and Parenti-Castelli: A1=(0,0), A2=(15.91,0), A3=(0,10); B1B2=17.04, B1B3=20.84, angle
/// at B1 0.88260311 rad; all lengths in [10, 32]; the pose is that of B1, phi the angle of B1B2.
std::shared_ptr<const Manipulator> three_rpr();

/// 3-RRR of Caro, Chablat, Goldsztejn, Ishii and Jermann, Artificial Intelligence 211, 2014.
std::shared_ptr<const Manipulator> three_rrr();

/// 3-RRR with the elbows actuated, on the same points.
std::shared_ptr<const Manipulator> three_rrr_actuated_elbow();

/// 3-PRR with rails along the sides of an equilateral triangle.
std::shared_ptr<const Manipulator> three_prr();

/// Crank about a horizontal tangent at `center`; q = 0 is radially outward, positive q turns down.
RevoluteActuation radial_crank(const Eigen::Vector3d& center, double degrees, double length);

/// Delta of Clavel with the lengths of the ABB IRB 360-800: base 0.200, crank 0.235, rod 0.800, platform
/// 0.045 m.
std::shared_ptr<const Manipulator> delta();

/// Linear Delta with vertical rails.
std::shared_ptr<const Manipulator> linear_delta();

/// Leg of a spherical manipulator on the unit sphere: link angles alpha1 (base axis to elbow axis) and alpha2
/// (elbow axis to platform axis) [rad]. `axis` and `platform_axis` are unit vectors.
Leg spherical_leg(std::size_t index, const Eigen::Vector3d& axis, const Eigen::Vector3d& zero_direction,
                  const Eigen::Vector3d& platform_axis, double alpha1, double alpha2);

/// Agile Eye of Gosselin: spherical 3-RRR with orthogonal axes and all link angles 90 deg, as in Bonev,
/// Chablat and Wenger, ICRA 2006.
std::shared_ptr<const Manipulator> agile_eye();

/// Spherical 3-RRR without symmetry.
std::shared_ptr<const Manipulator> spherical_three_rrr();

/// Gough-Stewart platform with 40 real assembly modes (Dietmaier 1998); L1 = 1 and lengths as in
/// `dietmaier_lengths`.
std::shared_ptr<const Manipulator> dietmaier();

JointVector dietmaier_lengths();

/// Stewart platform 6-6, semi-regular hexagons in both planes.
std::shared_ptr<const Manipulator> stewart();

/// Stewart platform 6-6 with planar but otherwise general base and platform.
std::shared_ptr<const Manipulator> planar_stewart();

/// Octahedral Stewart platform 3-3: pairs of legs share their joints on the base, and other pairs on the
/// platform.
std::shared_ptr<const Manipulator> octahedral_stewart();

/// Hexa (Pierrot): six cranks in three parallel pairs.
std::shared_ptr<const Manipulator> hexa();

/// 6-PUS with six vertical rails.
std::shared_ptr<const Manipulator> six_pus();

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ROBOTS_H
