// SPDX-License-Identifier: BSD-3-Clause
#include "python/arrays.h"

#include "tools/arguments.h"
#include "tools/report/report.h"

#include <nlohmann/json.hpp>

#include "python/bindings.h"
#include <algorithm>
#include <cmath>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

std::string shape_text(const Array& values) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < values.ndim(); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(values.shape(i));
  return text + (values.ndim() == 1 ? ",)" : ")");
}

/// The rows of an array of that many columns, or the one row of an array without the first axis.
std::vector<PoseCoordinates> rows_of(const std::string& name, const Array& values, std::size_t columns) {
  const bool is_row = values.ndim() == 1, is_table = values.ndim() == 2;
  if (!(is_row || is_table) || values.shape(values.ndim() - 1) != static_cast<py::ssize_t>(columns))
    throw InvalidDescription({name + " has shape " + shape_text(values) + "; give (" +
                              std::to_string(columns) + ",), or (n, " + std::to_string(columns) +
                              ") where several are meant."});
  const auto count = is_row ? std::size_t{1} : static_cast<std::size_t>(values.shape(0));
  std::vector<PoseCoordinates> rows;
  rows.reserve(count);
  const auto size = static_cast<Eigen::Index>(columns);
  for (std::size_t i = 0; i < count; ++i)
    rows.emplace_back(Eigen::Map<const Eigen::VectorXd>(values.data() + i * columns, size));
  return rows;
}

[[noreturn]] void refuse_row(const std::string& name, std::size_t row, const std::string& why) {
  throw InvalidDescription({"Row " + std::to_string(row) + " of " + name + ", from 0, " + why});
}

template <class Vector>
void put(const Vector& values, double* at) {
  std::copy(values.data(), values.data() + values.size(), at);
}

py::ssize_t size_of(std::size_t count) { return static_cast<py::ssize_t>(count); }

}  // namespace

std::vector<Pose> poses_of(const std::string& name, const Manipulator& manipulator, const Array& values) {
  const TaskSpace space = manipulator.task_space();
  std::vector<Pose> poses;
  for (const PoseCoordinates& row : rows_of(name, values, coordinate_names(space).size())) {
    const auto pose = pose_from_coordinates(manipulator.motions(), row);
    if (!pose)
      refuse_row(name, poses.size(),
                 "has a number that is not finite or a quaternion of zero length; give finite coordinates.");
    poses.push_back(*pose);
  }
  return poses;
}

Pose pose_of(const std::string& name, const Manipulator& manipulator, const Array& values) {
  const std::vector<Pose> poses = poses_of(name, manipulator, values);
  if (values.ndim() != 1)
    throw InvalidDescription({name + " has shape " + shape_text(values) + "; give one pose."});
  return poses.front();
}

std::vector<JointVector> joints_of(const std::string& name, const Manipulator& manipulator,
                                   const Array& values) {
  std::vector<JointVector> joints;
  for (const PoseCoordinates& row : rows_of(name, values, manipulator.leg_count())) {
    if (!row.allFinite())
      refuse_row(name, joints.size(), "has a number that is not finite; give finite values.");
    joints.emplace_back(row);
  }
  return joints;
}

Array empty_array(std::vector<py::ssize_t> shape) { return Array(std::move(shape)); }

Array array_of(TaskSpace space, const std::vector<Pose>& poses) {
  const std::size_t columns = coordinate_names(space).size();
  Array result = empty_array({size_of(poses.size()), size_of(columns)});
  double* next = result.mutable_data();
  for (const Pose& pose : poses) {
    put(pose_coordinates(space, pose), next);
    next += columns;
  }
  return result;
}

Array array_of(TaskSpace space, const Pose& pose) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  Array result = empty_array({coordinates.size()});
  put(coordinates, result.mutable_data());
  return result;
}

Array array_of(const TaskVector& values) {
  Array result = empty_array({values.size()});
  put(values, result.mutable_data());
  return result;
}

Array array_of(const std::vector<TaskVector>& rows, std::size_t columns) {
  Array result = empty_array({size_of(rows.size()), size_of(columns)});
  double* next = result.mutable_data();
  for (const TaskVector& row : rows) {
    put(row, next);
    next += columns;
  }
  return result;
}

Array array_of(const std::vector<double>& values) {
  Array result = empty_array({size_of(values.size())});
  put(values, result.mutable_data());
  return result;
}

Array array_of(const std::vector<Box>& boxes, std::size_t dimension) {
  Array result = empty_array({size_of(boxes.size()), size_of(dimension), 2});
  double* next = result.mutable_data();
  for (const Box& box : boxes)
    for (std::size_t i = 0; i < dimension; ++i) {
      *next++ = box.lower[i];
      *next++ = box.upper[i];
    }
  return result;
}

py::object object_of(const nlohmann::json& json) {
  return py::module::import("json").attr("loads")(tools::to_text(json));
}

std::string signs_text(const py::object& given) {
  if (py::isinstance<py::str>(given) || !py::isinstance<py::iterable>(given)) return py::str(given);
  std::string text;
  for (const py::handle each : given) {
    const std::string sign = py::str(each);
    text += (text.empty() ? "(" : ",") + std::string(sign == "1" ? "+" : sign == "-1" ? "-" : "?");
  }
  return text + ")";
}

WorkingMode mode_of(const std::string& name, const Manipulator& manipulator, const py::object& signs) {
  Problems problems;
  const auto mode = tools::parse_mode(name, manipulator, signs_text(signs), problems);
  refuse_any(problems);
  return *mode;
}

}  // namespace parallel_aspects::python
