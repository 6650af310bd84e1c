// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/design/design_lengths.h"

#include "model/overloaded.h"

#include <array>
#include <variant>

namespace parallel_aspects {
namespace {

constexpr std::array<const char*, 6> part_names{"crank", "rod", "inner", "outer", "base", "anchor"};
constexpr std::array<const char*, 3> axis_names{"_x", "_y", "_z"};

bool is_point(DesignPart part) { return part == DesignPart::base || part == DesignPart::anchor; }

Eigen::Vector3d& base_of(Leg& leg) {
  return std::visit(Overloaded{[](RevoluteActuation& crank) -> Eigen::Vector3d& { return crank.center; },
                               [](PrismaticActuation& rail) -> Eigen::Vector3d& { return rail.origin; },
                               [](StrutActuation& strut) -> Eigen::Vector3d& { return strut.base; },
                               [](ElbowActuation& elbow) -> Eigen::Vector3d& { return elbow.base; }},
                    leg.actuation);
}

/// A link that the leg has.
double& link_of(Leg& leg, DesignPart part) {
  const auto rod = [&leg](const auto&) -> double& { return leg.rod_length; };
  return std::visit(Overloaded{[&](RevoluteActuation& crank) -> double& {
                                 return part == DesignPart::crank ? crank.radius : rod(crank);
                               },
                               [&](PrismaticActuation& rail) -> double& { return rod(rail); },
                               [&](StrutActuation& strut) -> double& { return rod(strut); },
                               [&](ElbowActuation& elbow) -> double& {
                                 return part == DesignPart::inner ? elbow.inner_length : elbow.outer_length;
                               }},
                    leg.actuation);
}

std::vector<DesignPart> links_of(const Leg& leg) {
  switch (leg.kind().type) {
    case LegType::revolute:
      return {DesignPart::crank, DesignPart::rod};
    case LegType::prismatic:
      return {DesignPart::rod};
    case LegType::strut:
      return {};
    case LegType::elbow:
      return {DesignPart::inner, DesignPart::outer};
  }
  return {};
}

}  // namespace

// Where the platform only turns, lengths are of the links' own choosing, and none of them changes an aspect.
std::vector<DesignLength> design_lengths(const Manipulator& manipulator) {
  std::vector<DesignLength> lengths;
  if (manipulator.task_space() == TaskSpace::SO3) return lengths;
  const std::size_t axes = is_planar(manipulator.task_space()) ? 2 : 3;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    for (const DesignPart link : links_of(manipulator.leg(j))) lengths.push_back({link, j, 0});
    for (const DesignPart point : {DesignPart::base, DesignPart::anchor})
      for (std::size_t axis = 0; axis < axes; ++axis) lengths.push_back({point, j, axis});
  }
  return lengths;
}

std::string name_of(const DesignLength& length) {
  return std::string(part_names[static_cast<std::size_t>(length.part)]) + "_" +
         std::to_string(length.leg + 1) + (is_point(length.part) ? axis_names[length.axis] : "");
}

std::string family_of(const DesignLength& length) {
  return std::string(part_names[static_cast<std::size_t>(length.part)]) +
         (is_point(length.part) ? axis_names[length.axis] : "");
}

double& number_of(Leg& leg, const DesignLength& length) {
  const auto axis = static_cast<Eigen::Index>(length.axis);
  if (length.part == DesignPart::base) return base_of(leg)[axis];
  if (length.part == DesignPart::anchor) return leg.anchor[axis];
  return link_of(leg, length.part);
}

}  // namespace parallel_aspects
