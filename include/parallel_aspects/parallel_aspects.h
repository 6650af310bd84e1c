// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PARALLEL_ASPECTS_H
#define PARALLEL_ASPECTS_PARALLEL_ASPECTS_H

/// @file
/// Every public header, for those who would rather wait for the compiler than search for names.

/// Aspects of parallel robots: kinematics, certified maps, distances to singularities, tracking and proved
/// motions.
///
/// Units are m, rad and s. Poses are given in the task frame, joint values in the order of the legs.
/// Functions say where they allocate or throw; what is called proved is a theorem, computed with outward
/// rounding.
namespace parallel_aspects {}

#include "parallel_aspects/arms/serial_arm.h"
#include "parallel_aspects/ask/arm.h"
#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/distance.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/ask/jacobian.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/ask/plan.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/robot_description.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/ask/uniqueness_question.h"
#include "parallel_aspects/ask/workspace.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/design.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/regular_workspace.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "parallel_aspects/motion/choose_working_mode.h"
#include "parallel_aspects/motion/motion_guard.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/singularity/indices.h"
#include "parallel_aspects/tracking/hazards.h"
#include "parallel_aspects/tracking/tracker.h"
#include "parallel_aspects/urdf/mechanism.h"

#endif  // PARALLEL_ASPECTS_PARALLEL_ASPECTS_H
