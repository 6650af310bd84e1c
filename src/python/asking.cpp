// SPDX-License-Identifier: BSD-3-Clause
#include "python/asking.h"

#include "model/message_text.h"
#include "tools/arguments.h"
#include "tools/report/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <pybind11/stl.h>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

Array array_named(const std::string& name, const py::object& given) {
  Array array = Array::ensure(given);
  if (array) return array;
  PyErr_Clear();
  throw InvalidDescription(
      {name + " is no array of numbers; give rows of the same length, of finite numbers."});
}

std::string text_of_any(const py::object& given) { return py::repr(given).cast<std::string>(); }

}  // namespace

void KeywordReader::require_known() const {
  for (const auto& [key, value] : keywords_) {
    const std::string name = py::str(key);
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    std::string all;
    for (const std::string& each : known_) all += (all.empty() ? "" : ", ") + each;
    throw py::type_error("There is no keyword '" + name + "'; there are " + all + ".");
  }
}

// Words of several are separated by commas.
void KeywordReader::read(const std::string& /*name*/, const Object& given, std::string& value) {
  if (!py::isinstance<py::str>(given) && py::hasattr(given, "__iter__"))
    value = py::str(",").attr("join")(given).cast<std::string>();
  else
    value = py::module::import("os").attr("fspath")(given).cast<std::string>();
}

void KeywordReader::read(const std::string& name, const Object& given, double& value) {
  value = PyFloat_AsDouble(given.ptr());
  const bool is_number = PyErr_Occurred() == nullptr;
  PyErr_Clear();
  if (!is_number || !std::isfinite(value) || !(value > 0.0))
    throw InvalidDescription({name + " is " + text_of_any(given) + "; give a positive number."});
}

void KeywordReader::read(const std::string& name, const Object& given, bool& value) {
  if (!py::isinstance<py::bool_>(given))
    throw InvalidDescription({name + " is " + text_of_any(given) + "; give True or False."});
  value = given.cast<bool>();
}

void KeywordReader::read(const std::string& name, const Object& given, Pose& value) {
  value = pose_of(name, robot_, array_named(name, given));
}

void KeywordReader::read(const std::string& name, const Object& given, WorkingMode& value) {
  value = mode_of(name, robot_, given);
}

void KeywordReader::read(const std::string& name, const Object& given, JointVector& value) {
  const Array array = array_named(name, given);
  const std::vector<JointVector> rows = joints_of(name, robot_, array);
  if (array.ndim() != 1) throw InvalidDescription({name + " has two axes; give one value a leg."});
  value = rows.front();
}

void KeywordReader::read(const std::string& name, const Object& given, MapSlice& value) {
  Problems problems;
  if (py::isinstance<py::str>(given)) {
    value = tools::parse_slice(name, robot_, py::str(given), problems);
    return refuse_any(problems);
  }
  std::vector<HeldCoordinate> held;
  read(name, given, held);
  value = make_slice(robot_, held, problems);
  refuse_any(problems);
}

void KeywordReader::read(const std::string& name, const Object& given, HeldJoint& value) {
  Problems problems;
  std::string text = py::str(given);
  if (!py::isinstance<py::str>(given)) {
    std::vector<HeldCoordinate> values;
    read(name, given, values);
    text.clear();
    for (const HeldCoordinate& each : values)
      text += (text.empty() ? "" : " ") + each.name + "=" + number_text(each.value, exact_digits);
  }
  value = tools::parse_held_joint(name, robot_, text, problems);
  refuse_any(problems);
}

void KeywordReader::read(const std::string& name, const Object& given, HeldRange& value) {
  Problems problems;
  std::string text = py::str(given);
  if (!py::isinstance<py::str>(given)) {
    std::vector<ask::NamedRange> ranges;
    read(name, given, ranges);
    text.clear();
    for (const ask::NamedRange& each : ranges)
      text += (text.empty() ? "" : " ") + each.name + "=" + number_text(each.lower, exact_digits) + ":" +
              number_text(each.upper, exact_digits);
  }
  value = tools::parse_held_range(name, robot_, text, problems);
  refuse_any(problems);
}

std::vector<py::object> KeywordReader::listed(const Object& given) {
  if (py::isinstance<py::str>(given) || !py::isinstance<py::iterable>(given)) return {given};
  std::vector<Object> result;
  for (const py::handle each : given) result.push_back(py::reinterpret_borrow<Object>(each));
  return result;
}

void KeywordReader::read(const std::string& name, const Object& given, std::vector<double>& values) {
  Problems problems;
  if (py::isinstance<py::str>(given)) {
    values = tools::parse_ratio(name, py::str(given), problems);
    return refuse_any(problems);
  }
  const Array array = array_named(name, given);
  values.assign(array.data(), array.data() + array.size());
}

// (1, -1) is one of them, as "(+,-) (-,+)" is two.
void KeywordReader::read(const std::string& name, const Object& given, std::vector<WorkingMode>& values) {
  Problems problems;
  std::vector<Object> all = listed(given);
  if (!all.empty() && PyIndex_Check(all.front().ptr()) != 0) all = {given};
  for (const Object& each : all)
    for (const WorkingMode& mode : tools::parse_modes(name, robot_, signs_text(each), problems))
      values.push_back(mode);
  refuse_any(problems);
}

void KeywordReader::read(const std::string& name, const Object& given, std::vector<HeldCoordinate>& values) {
  Problems problems;
  if (py::isinstance<py::str>(given)) values = tools::parse_values(name, py::str(given), problems);
  if (py::isinstance<py::str>(given)) return refuse_any(problems);
  try {
    for (const auto& [coordinate, number] : py::dict(given))
      values.push_back({py::str(coordinate), number.cast<double>()});
  } catch (const std::exception&) {  // not a mapping, or not of numbers
    throw InvalidDescription({name + " is " + text_of_any(given) +
                              "; give what is held with its value, such as {\"z\": 1} or \"z=1\"."});
  }
}

void KeywordReader::read(const std::string& name, const Object& given, std::vector<ask::NamedRange>& values) {
  Problems problems;
  if (py::isinstance<py::str>(given)) values = tools::parse_ranges(name, py::str(given), problems);
  if (py::isinstance<py::str>(given)) return refuse_any(problems);
  try {
    for (const auto& [coordinate, ends] : py::dict(given)) {
      const auto [lower, upper] = ends.cast<std::pair<double, double>>();
      values.push_back({py::str(coordinate), lower, upper});
    }
  } catch (const std::exception&) {
    throw InvalidDescription({name + " is " + text_of_any(given) +
                              "; give ranges by name, such as {\"x\": (-1, 1)} or \"x=-1:1\"."});
  }
}

namespace {

using Times = std::vector<double>;

void require_as_many(const Times& times, std::size_t count, const std::string& name) {
  if (times.size() != count)
    throw InvalidDescription({"times has " + std::to_string(times.size()) + " entries, and " + name + " " +
                              std::to_string(count) + "; give as many."});
}

}  // namespace

void KeywordReader::read(const std::string& /*name*/, const Object& given,
                         std::vector<PoseWaypoint>& waypoints) {
  const auto [times, values] = given.cast<std::pair<Times, Array>>();
  const std::vector<Pose> poses = poses_of("poses", robot_, values);
  require_as_many(times, poses.size(), "poses");
  for (std::size_t i = 0; i < poses.size(); ++i) waypoints.push_back({times[i], poses[i]});
}

void KeywordReader::read(const std::string& /*name*/, const Object& given,
                         std::vector<JointWaypoint>& waypoints) {
  const auto [times, values] = given.cast<std::pair<Times, Array>>();
  const std::vector<JointVector> joints = joints_of("q", robot_, values);
  require_as_many(times, joints.size(), "q");
  for (std::size_t i = 0; i < joints.size(); ++i) waypoints.push_back({times[i], joints[i], {}, {}});
}

unsigned KeywordReader::whole_number(const std::string& name, const Object& given, unsigned least,
                                     unsigned largest) {
  const long long value = PyIndex_Check(given.ptr()) != 0 ? PyLong_AsLongLong(given.ptr()) : -1;
  PyErr_Clear();
  if (value >= least && value <= largest) return static_cast<unsigned>(value);
  throw InvalidDescription({name + " is " + text_of_any(given) + "; give a whole number from " +
                            std::to_string(least) + " to " + std::to_string(largest) + "."});
}

void DictWriter::operator()(const ask::Field& /*field*/, const std::vector<PathPoint>& points) {
  std::vector<Pose> poses;
  std::vector<TaskVector> q;
  py::list modes;
  for (const PathPoint& point : points) {
    poses.push_back(point.pose);
    q.push_back(point.q);
    modes.append(to_string(point.mode));
  }
  dict_["poses"] = array_of(robot_.task_space(), poses);
  dict_["q"] = array_of(q, robot_.leg_count());
  dict_["modes"] = py::tuple(modes);
}

py::object DictWriter::object_of_value(const std::vector<int>& values) const {
  return py::tuple(py::cast(values));
}

py::object DictWriter::object_of_value(const TaskMatrix& matrix) const {
  std::vector<TaskVector> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(matrix.row(i).transpose());
  return array_of(rows, rows.size());
}

py::object DictWriter::object_of_value(const std::vector<HeldCoordinate>& values) const {
  std::vector<double> numbers;
  for (const HeldCoordinate& each : values) numbers.push_back(each.value);
  return array_of(numbers);
}

py::object DictWriter::object_of_value(const std::vector<ask::NamedRange>& ranges) const {
  py::dict result;
  for (const ask::NamedRange& each : ranges)
    result[py::str(each.name)] = py::make_tuple(each.lower, each.upper);
  return std::move(result);
}

py::object DictWriter::object_of_value(const WorkingMode& mode) const { return py::str(to_string(mode)); }

py::object DictWriter::object_of_value(const Pose& pose) const { return array_of(robot_.task_space(), pose); }

py::object DictWriter::object_of_value(const std::vector<Pose>& poses) const {
  return array_of(robot_.task_space(), poses);
}

py::object DictWriter::object_of_value(const MapSlice& slice) const {
  return object_of(tools::json_slice(slice));
}

py::object DictWriter::object_of_value(const TimedPath& timed) const {
  std::vector<double> times;
  std::vector<TaskVector> q, velocities;
  for (const JointWaypoint& waypoint : timed.waypoints) {
    times.push_back(waypoint.time);
    q.push_back(waypoint.q);
    velocities.push_back(waypoint.velocity);
  }
  return py::dict(py::arg("message") = timed.message, py::arg("times") = array_of(times),
                  py::arg("q") = array_of(q, robot_.leg_count()),
                  py::arg("velocities") = array_of(velocities, robot_.leg_count()),
                  py::arg("corners_rounded") = timed.rounded, py::arg("stops") = timed.stops);
}

void add_remarks(const ask::PlanAnswer& plan, py::dict& answer) {
  for (const std::string& remark : plan.remarks)
    answer["reason"] =
        py::str(answer["reason"].cast<std::string>() + " " + ask::with_names(remark, ask::plain_name));
}

void add_remarks(const ask::CheckAnswer& answer, py::dict& result) {
  std::vector<double> times, parallel;
  std::vector<Pose> poses;
  std::vector<TaskVector> q, serial;
  for (const TrajectorySample& sample : answer.check.samples) {
    times.push_back(sample.time);
    parallel.push_back(sample.parallel_index);
    poses.push_back(sample.pose);
    q.push_back(sample.q);
    serial.push_back(sample.serial_indices);
  }
  const std::size_t legs = answer.speeds.size();
  result["samples"] =
      py::dict(py::arg("times") = array_of(times), py::arg("poses") = array_of(answer.task_space, poses),
               py::arg("q") = array_of(q, legs), py::arg("parallel_index") = array_of(parallel),
               py::arg("serial_indices") = array_of(serial, legs));
}

void warn_of(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace parallel_aspects::python
