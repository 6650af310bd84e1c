// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/design/design_parameters.h"

#include "aspects/map/map_plan.h"
#include "aspects/symmetry/robot_symmetry.h"
#include "model/overloaded.h"
#include "parallel_aspects/aspects/design.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
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

// Where the platform only turns, the lengths of links are arbitrary, and none of them changes an aspect.
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

namespace {

using Tie = std::pair<DesignLength, double>;

/// The image of a number of a leg under a symmetry: which number of which leg it becomes, and its value.
Tie image_of(const RobotSymmetry& symmetry, const DesignLength& length, double value) {
  DesignLength image = length;
  image.leg = symmetry.leg_image[length.leg];
  if (length.part != DesignPart::base && length.part != DesignPart::anchor) return {image, value};
  const bool is_base = length.part == DesignPart::base;
  const Eigen::Matrix3d& turn = is_base ? symmetry.motion.base : symmetry.motion.platform;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double sign = turn(axis, static_cast<Eigen::Index>(length.axis));
    if (sign == 0.0) continue;
    image.axis = static_cast<std::size_t>(axis);
    return {image, sign * value + (is_base ? symmetry.motion.shift[axis] : 0.0)};
  }
  return {image, value};
}

/// Parameters of a robot, and which follow each other.
class Parameters {
 public:
  explicit Parameters(const Manipulator& manipulator, bool keep_ties)
      : legs_(manipulator.legs()), lengths_(design_lengths(manipulator)) {
    MapPlan plan;
    if (!keep_ties || manipulator.task_space() == TaskSpace::SE3) return;
    if (make_map_plan(manipulator, {}, plan).empty())
      symmetries_ = find_robot_symmetries(manipulator, plan.space->region());
  }

  const std::vector<DesignLength>& lengths() const { return lengths_; }

  /// The numbers that a name means: one, or those of all legs.
  std::vector<DesignLength> named(const std::string& name) const {
    std::vector<DesignLength> found;
    for (const DesignLength& each : lengths_)
      if (name_of(each) == name || family_of(each) == name) found.push_back(each);
    return found;
  }

  double value(const DesignLength& length) const {
    Leg leg = legs_[length.leg];
    return number_of(leg, length);
  }

  /// The numbers that follow one with this value, without itself; none where the value breaks a symmetry,
  /// which the design gives up then.
  std::vector<Tie> ties(const DesignLength& length, double value) const {
    std::vector<Tie> found{{length, value}};
    for (const RobotSymmetry& symmetry : symmetries_) {
      const Tie tie = image_of(symmetry, length, value);
      const auto same = std::find_if(found.begin(), found.end(),
                                     [&tie](const Tie& other) { return other.first == tie.first; });
      if (same == found.end())
        found.push_back(tie);
      else if (same->second != tie.second)
        return {};
    }
    found.erase(found.begin());
    return found;
  }

  /// The numbers that are tied to it, for any value.
  std::vector<DesignLength> tied(const DesignLength& length) const {
    std::vector<DesignLength> result;
    constexpr double other_than_it_is = 1.25;
    for (const Tie& tie : ties(length, other_than_it_is * value(length) + 1.0)) result.push_back(tie.first);
    return result;
  }

 private:
  std::vector<Leg> legs_;
  std::vector<DesignLength> lengths_;
  std::vector<RobotSymmetry> symmetries_;
};

std::string unknown_text(const Parameters& parameters, const std::string& name) {
  std::string text = "There is no parameter '" + name + "'; ";
  if (parameters.lengths().empty())
    return text + "this robot has none, since only angles between its axes count.";
  text += "the first leg has";
  std::string separator = " ";
  for (const DesignLength& each : parameters.lengths())
    if (each.leg == 0) text += std::exchange(separator, ", ") + name_of(each);
  return text + ".";
}

bool overlap(const std::vector<DesignLength>& a, const std::vector<DesignLength>& b) {
  return std::any_of(a.begin(), a.end(), [&b](const DesignLength& each) {
    return std::find(b.begin(), b.end(), each) != b.end();
  });
}

}  // namespace

std::vector<DesignParameter> design_parameters(const Manipulator& manipulator) {
  const Parameters parameters(manipulator, true);
  std::vector<DesignParameter> result;
  for (const DesignLength& length : parameters.lengths()) {
    result.push_back({name_of(length), parameters.value(length), {}});
    for (const DesignLength& tied : parameters.tied(length)) result.back().tied.push_back(name_of(tied));
  }
  return result;
}

Problems problems_of(const Manipulator& manipulator, const std::vector<std::string>& names, bool keep_ties) {
  const Parameters parameters(manipulator, keep_ties);
  Problems problems;
  std::vector<std::pair<std::string, std::vector<DesignLength>>> before;
  for (const std::string& name : names) {
    std::vector<DesignLength> lengths = parameters.named(name);
    if (lengths.empty()) problems.push_back(unknown_text(parameters, name));
    for (const auto& [other, set] : before)
      if (overlap(set, lengths))
        problems.push_back(
            "'" + name + "' and '" + other +
            "' are numbers of the same link, or tied by a symmetry of the robot; give one of them, "
            "or vary them untied.");
    if (lengths.size() == 1)
      for (const DesignLength& tied : parameters.tied(lengths.front())) lengths.push_back(tied);
    before.emplace_back(name, std::move(lengths));
  }
  return problems;
}

std::shared_ptr<const Manipulator> with_design(const Manipulator& manipulator, const DesignValues& values,
                                               bool keep_ties) {
  const Parameters parameters(manipulator, keep_ties);
  ManipulatorDescription description = manipulator.description();
  for (const auto& [name, value] : values) {
    const std::vector<DesignLength> named = parameters.named(name);
    for (const DesignLength& length : named) number_of(description.legs[length.leg], length) = value;
    if (named.size() != 1) continue;
    for (const auto& [length, image] : parameters.ties(named.front(), value))
      number_of(description.legs[length.leg], length) = image;
  }
  return std::make_shared<const Manipulator>(std::move(description));
}

}  // namespace parallel_aspects
