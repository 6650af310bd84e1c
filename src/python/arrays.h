// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_PYTHON_ARRAYS_H
#define PARALLEL_ASPECTS_PYTHON_ARRAYS_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <nlohmann/json_fwd.hpp>

#include <pybind11/numpy.h>
#include <string>
#include <vector>

namespace parallel_aspects::python {

/// What numpy makes of numbers, sequences of them and other arrays.
using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The poses in an array of shape (n, k) or (k,) of the k coordinates of the task space. Throws
/// `InvalidDescription` where it is of another shape, or has numbers that are not finite or a quaternion of
/// zero length.
std::vector<Pose> poses_of(const std::string& name, const Manipulator& manipulator, const Array& values);

/// The one pose in an array of shape (k,).
Pose pose_of(const std::string& name, const Manipulator& manipulator, const Array& values);

/// Joint values in an array of shape (n, legs) or (legs,), finite.
std::vector<JointVector> joints_of(const std::string& name, const Manipulator& manipulator,
                                   const Array& values);

/// An array of this shape, not filled.
Array empty_array(std::vector<pybind11::ssize_t> shape);

/// Shape (n, k).
Array array_of(TaskSpace space, const std::vector<Pose>& poses);
/// Shape (k,).
Array array_of(TaskSpace space, const Pose& pose);
/// Shape (legs,).
Array array_of(const TaskVector& values);
/// Shape (n, columns).
Array array_of(const std::vector<TaskVector>& rows, std::size_t columns);
/// Shape (n,).
Array array_of(const std::vector<double>& values);
/// Shape (n, d, 2): lower and upper end of each coordinate.
Array array_of(const std::vector<Box>& boxes, std::size_t dimension);

/// Objects as dictionaries, null as None.
pybind11::object object_of(const nlohmann::json& json);

/// (1, -1) as "(+,-)"; anything else as a text that is refused.
std::string signs_text(const pybind11::object& given);

/// The mode that such signs give; throws `InvalidDescription` where there is none.
WorkingMode mode_of(const std::string& name, const Manipulator& manipulator, const pybind11::object& signs);

}  // namespace parallel_aspects::python

#endif  // PARALLEL_ASPECTS_PYTHON_ARRAYS_H
