// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_slice.h"

#include "model/message_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

using Names = std::vector<std::string>;

const Names positions{"x", "y", "z"};
const Names angles{"roll", "pitch", "yaw"};

Names names_of(TaskSpace space) {
  if (space == TaskSpace::SO3) return angles;
  if (space == TaskSpace::SE3) return {"x", "y", "z", "roll", "pitch", "yaw"};
  return coordinate_names(space);
}

bool is_angle(const MapSlice& slice, const std::string& name) {
  return slice.joint ? slice.joint->is_angle : name.size() > 1;
}

/// The coordinates that are held, by name.
class Held {
 public:
  Held(TaskSpace space, const std::vector<HeldCoordinate>& coordinates)
      : names_(names_of(space)), coordinates_(coordinates) {}

  std::optional<double> value(const std::string& name) const {
    for (const HeldCoordinate& each : coordinates_)
      if (each.name == name) return each.value;
    return std::nullopt;
  }

  bool is_free(const std::string& name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end() && !value(name);
  }

  Names free_of(const Names& names) const {
    Names result;
    for (const std::string& name : names)
      if (is_free(name)) result.push_back(name);
    return result;
  }

  const Names& names() const noexcept { return names_; }
  const std::vector<HeldCoordinate>& coordinates() const noexcept { return coordinates_; }

 private:
  Names names_;
  const std::vector<HeldCoordinate>& coordinates_;
};

std::string slices_of_hinges(TaskSpace space) {
  return "Slices of " + std::string(name(space)) +
         " are not available yet; map its angles whole, which takes seconds, and leave the slice out.";
}

void check_each(TaskSpace space, const Held& held, Problems& problems) {
  Names seen;
  for (const HeldCoordinate& each : held.coordinates()) {
    if (std::find(held.names().begin(), held.names().end(), each.name) == held.names().end())
      problems.push_back("A slice of " + std::string(name(space)) + " has no coordinate '" + each.name +
                         "'; hold some of " + enumerated(held.names()) + ".");
    if (std::find(seen.begin(), seen.end(), each.name) != seen.end())
      problems.push_back("The slice holds '" + each.name + "' twice; leave one out.");
    if (!std::isfinite(each.value))
      problems.push_back("The slice holds '" + each.name + "' at no finite number; give one.");
    seen.push_back(each.name);
  }
}

void check_free(const Held& held, Problems& problems) {
  const Names free = held.free_of(held.names()), free_angles = held.free_of(angles);
  if (free.size() == held.names().size())
    problems.push_back("The slice holds nothing; hold some of " + enumerated(held.names()) + ", such as \"" +
                       held.names().back() + "=0\".");
  else if (free.empty())
    problems.emplace_back("The slice leaves no coordinate free; leave one to three.");
  else if (free.size() > max_map_dimension)
    problems.push_back("The slice leaves " + enumerated(free) + " free; leave one to three.");
  else if (free_angles.size() == 2 || (free_angles.size() == 3 && free.size() != 3))
    problems.push_back("The slice leaves the angles " + enumerated(free_angles) +
                       " free; hold all of them but one, or let all three turn with x, y and z held.");
}

Eigen::Quaterniond turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

/// Rz(yaw) Ry(pitch) Rx(roll) with the one free angle at zero is what is held; rotation the angle turns about
/// its axis, turned by the angles that come after it.
void set_orientation(const Held& held, MapSlice& slice) {
  using Eigen::Vector3d;
  const Eigen::Quaterniond yaw = turn(held.value("yaw").value_or(0.0), Vector3d::UnitZ());
  const Eigen::Quaterniond pitch = turn(held.value("pitch").value_or(0.0), Vector3d::UnitY());
  const Eigen::Quaterniond roll = turn(held.value("roll").value_or(0.0), Vector3d::UnitX());
  slice.held.orientation = yaw * pitch * roll;
  const Names free = held.free_of(angles);
  if (free.size() == 3) slice.rotation = MapSlice::Rotation::freely;
  if (free.size() != 1) return;
  slice.rotation = MapSlice::Rotation::about_axis;
  slice.angle_name = free.front();
  if (free.front() == "pitch") slice.axis = yaw * Vector3d::UnitY();
  if (free.front() == "roll") slice.axis = yaw * pitch * Vector3d::UnitX();
}

/// Why the slice holds no poses of the task space.
std::string find_foreign_part(TaskSpace space, const MapSlice& slice) {
  const bool plane = space == TaskSpace::T2 || space == TaskSpace::SE2;
  const Eigen::Vector3d& at = slice.held.position;
  const Eigen::Quaterniond& orientation = slice.held.orientation;
  if ((plane && (slice.moves[2] || at.z() != 0.0)) ||
      (space == TaskSpace::SO3 && (slice.free_positions() != 0 || !at.isZero(0.0))))
    return "moves the platform where it can not go; let it move within the task space";
  const bool turns = slice.rotation != MapSlice::Rotation::none;
  if (!has_rotation(space) && (turns || !orientation.vec().isZero(0.0)))
    return "turns the platform, which keeps its orientation; let it move only";
  const bool leaves_plane = !orientation.vec().head<2>().isZero(0.0) ||
                            (turns && (!slice.axis.head<2>().isZero(0.0) || !(slice.axis.z() > 0.0)));
  if (space == TaskSpace::SE2 && leaves_plane)
    return "turns the platform out of its plane; turn it about the z axis only";
  return "";
}

}  // namespace

std::size_t MapSlice::free_positions() const noexcept {
  return static_cast<std::size_t>(std::count(moves.begin(), moves.end(), true));
}

std::size_t MapSlice::dimension() const noexcept {
  if (joint) return 2;
  if (rotation == Rotation::freely) return free_positions() + 3;
  return free_positions() + (rotation == Rotation::about_axis ? 1U : 0U);
}

MapSlice make_slice(TaskSpace space, const std::vector<HeldCoordinate>& coordinates, Problems& problems) {
  const Held held(space, coordinates);
  const std::size_t known = problems.size();
  MapSlice slice;
  if (space == TaskSpace::T1)
    problems.emplace_back("T1 has no slices, since x is all there is; map it whole.");
  else if (has_hinges(space))
    problems.push_back(slices_of_hinges(space));
  else
    check_each(space, held, problems);
  if (problems.size() == known) check_free(held, problems);
  if (problems.size() > known) return slice;
  for (std::size_t i = 0; i < 3; ++i) {
    slice.moves[i] = held.is_free(positions[i]);
    slice.held.position[static_cast<Eigen::Index>(i)] = held.value(positions[i]).value_or(0.0);
  }
  if (space == TaskSpace::SE2) {
    slice.held.orientation = turn(held.value("phi").value_or(0.0), Eigen::Vector3d::UnitZ());
    if (held.is_free("phi")) slice.rotation = MapSlice::Rotation::about_axis;
  } else {
    set_orientation(held, slice);
  }
  slice.held_coordinates = coordinates;
  return slice;
}

std::string find_slice_problem(const Manipulator& manipulator, const MapSlice& slice) {
  const std::string start = "The slice of the poses of '" + manipulator.name() + "' ";
  const TaskSpace space = manipulator.task_space();
  if (has_hinges(space)) return slices_of_hinges(space);
  if (slice.joint && slice.free_positions() != 0)
    return start + "holds a joint, but lets positions move too; hold one or the other.";
  if (slice.joint) return find_held_joint_problem(manipulator, *slice.joint);
  const double norm = slice.held.orientation.norm(), axis = slice.axis.norm();
  if (!slice.held.position.allFinite() || !(std::abs(norm - 1.0) < 1e-6))
    return start + "holds a pose that is not finite or has no unit quaternion; give another.";
  if (!std::isfinite(axis) || !(axis > 1e-3 && axis < 1e3))
    return start + "has an axis of no direction; give a unit vector.";
  const std::size_t dimension = slice.dimension();
  if (dimension < 1 || dimension > max_map_dimension || dimension >= degrees_of_freedom(space))
    return start + "has " + std::to_string(dimension) +
           " free coordinates; leave one to three free, and hold at least one.";
  const std::string foreign = find_foreign_part(space, slice);
  return foreign.empty() ? "" : start + foreign + ".";
}

std::vector<std::string> coordinate_names(const MapSlice& slice) {
  if (slice.joint) return {"direction", "phi"};
  Names names;
  for (std::size_t i = 0; i < 3; ++i)
    if (slice.moves[i]) names.push_back(positions[i]);
  if (slice.rotation == MapSlice::Rotation::about_axis) names.push_back(slice.angle_name);
  return names;
}

std::string measure_unit(const MapSlice& slice) {
  if (slice.joint) return "rad^2";
  if (slice.rotation == MapSlice::Rotation::freely) return "rad^3";
  const std::array<const char*, 4> lengths{"", "m", "m^2", "m^3"};
  const std::string length = lengths[slice.free_positions()];
  if (slice.rotation == MapSlice::Rotation::none) return length;
  return length.empty() ? "rad" : length + " rad";
}

std::string to_string(const MapSlice& slice) {
  std::string text;
  for (const HeldCoordinate& each : slice.held_coordinates)
    text += (text.empty() ? "" : ", ") + each.name + " = " + number_text(each.value) +
            (is_angle(slice, each.name) ? " rad" : " m");
  if (slice.joint || slice.rotation != MapSlice::Rotation::about_axis || slice.angle_name != "phi")
    return text;
  return text + (text.empty() ? "" : ", ") + "phi turns about (" + number_text(slice.axis.x()) + ", " +
         number_text(slice.axis.y()) + ", " + number_text(slice.axis.z()) + ")";
}

}  // namespace parallel_aspects
