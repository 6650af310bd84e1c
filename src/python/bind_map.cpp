// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/plane_scene.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// Of a roadmap its fields.
py::object mapped(const CoreRobot& robot, const ask::MapQuestion& question, const py::object& progress) {
  SharedSession questions(robot);
  const ask::MapAnswer answer = answered(questions, question, progress);
  py::dict fields = dict_of(*robot.manipulator, answer);
  if (answer.sampled) return std::move(fields);
  return py::cast(CoreMap(robot, answer.map, std::move(fields)));
}

py::object compute(const CoreRobot& robot, const py::dict& keywords, const py::object& progress) {
  return mapped(robot, read_question<ask::MapQuestion>(*robot.manipulator, keywords), progress);
}

py::object load_file(const CoreRobot& robot, const std::string& file, const py::dict& keywords) {
  auto question = read_question<ask::MapQuestion>(*robot.manipulator, keywords);
  question.source.load = file;
  question.source.must_load = true;
  return mapped(robot, question, py::none());
}

void save(const CoreMap& map, const std::string& file) {
  const SaveResult result = run_long(py::none(), [&](const MapControl&) { return save_map(*map.map, file); });
  if (!result) throw InvalidDescription({result.message});
}

void require_aspect(const CoreMap& map, int id) {
  const std::size_t count = map.map->aspects().size();
  if (id < 1 || static_cast<std::size_t>(id) > count)
    throw InvalidDescription({"There is no aspect " + std::to_string(id) + "; the map has " +
                              std::to_string(count) + ", counted from 1."});
}

/// Ids; 0 where undecided, -1 where proved to lie in none, -2 where not mapped.
py::array_t<int> locate(const CoreMap& map, const Array& values, const py::object& signs) {
  const std::vector<Pose> poses = poses_of("poses", map.robot(), values);
  const WorkingMode mode = mode_of("mode", map.robot(), signs);
  py::array_t<int> result(static_cast<py::ssize_t>(poses.size()));
  int* ids = result.mutable_data();
  run_long(py::none(), [&](const MapControl& control) {
    for (std::size_t i = 0; i < poses.size() && !is_cancelled(control); ++i) {
      const Location location = map.map->locate(poses[i], mode);
      ids[i] = location.status == LocationStatus::inside      ? location.aspect
               : location.status == LocationStatus::undecided ? 0
               : location.status == LocationStatus::outside   ? -1
                                                              : -2;
    }
    return true;
  });
  return result;
}

Array boxes_of(const CoreMap& map, int aspect) {
  require_aspect(map, aspect);
  std::vector<Box> boxes;
  map.map->visit_inside_leaves(aspect, [&boxes](const Box& box) { boxes.push_back(box); });
  return array_of(boxes, map.map->coordinates().size());
}

Array undecided_boxes(const CoreMap& map, const py::object& signs) {
  std::vector<Box> boxes;
  map.map->visit_undecided_leaves(mode_of("mode", map.robot(), signs),
                                  [&boxes](const Box& box) { boxes.push_back(box); });
  return array_of(boxes, map.map->coordinates().size());
}

/// The plane that is drawn: all there is in T2, else at that phi, z or torsion, or the slice of the map.
PosePlane plane_at(const CoreMap& map, double level) {
  if (!map.map->slice() && degrees_of_freedom(map.robot().task_space()) == 1)
    throw InvalidDescription(
        {"The map is of a line; there is no plane to draw. boxes(aspect) has its ranges."});
  if (map.map->slice() && map.map->slice()->dimension() != 2)
    throw InvalidDescription(
        {"The slice of the map has not two free coordinates; only planes are drawn. Map a slice with two."});
  return plane_of(*map.map, PoseSlice(map.robot().motions(), level));
}

Array points_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<TaskVector> rows(points.begin(), points.end());
  return array_of(rows, 2);
}

py::dict dict_of(const PlaneArea& area) {
  py::list polygons;
  for (const auto& corners : area.polygons) polygons.append(points_of(corners));
  py::dict result;
  result["aspect"] = area.aspect;
  result["color"] = color_text(area.color);
  result["text_color"] = color_text(readable_on(area.color));
  result["label"] = area.label;
  result["title"] = area.title;
  result["polygons"] = polygons;
  return result;
}

py::dict dict_of(const BoundaryCurves& curves) {
  py::list pieces;
  for (std::size_t i = 0; i + 1 < curves.ends.size(); i += 2)
    pieces.append(points_of({curves.ends[i], curves.ends[i + 1]}));
  py::dict result;
  result["kind"] = curves.style->name;
  result["color"] = color_text(curves.style->color);
  result["words"] = curves.style->words;
  result["pieces"] = pieces;
  return result;
}

/// What is drawn of one working mode in a plane.
py::dict scene(const CoreMap& map, const py::object& signs, double level, int cells) {
  if (cells < 2 || cells > 10'000)
    throw InvalidDescription({"cells is " + std::to_string(cells) + "; give 2 to 10000."});
  const WorkingMode mode = mode_of("mode", map.robot(), signs);
  const PosePlane plane = plane_at(map, level);
  const PlaneScene drawn =
      run_long(py::none(), [&](const MapControl&) { return pose_scene(*map.map, plane, mode, cells); });
  py::list areas, curves;
  for (const PlaneArea& area : drawn.areas) areas.append(dict_of(area));
  for (const BoundaryCurves& each : curves_of(drawn.boundaries)) curves.append(dict_of(each));
  py::dict result;
  result["axes"] = py::make_tuple(drawn.axes[0].title, drawn.axes[1].title);
  result["keeps_proportion"] = drawn.keeps_proportion;
  result["areas"] = areas;
  result["curves"] = curves;
  return result;
}

}  // namespace

void bind_map(RobotClass& robot, MapClass& map) {
  robot.def("map", compute);
  robot.def("load_map", load_file);
  map.def_readonly("fields", &CoreMap::fields);
  map.def_property_readonly("coordinates", [](const CoreMap& self) { return self.map->coordinates(); });
  map.def("is_of", [](const CoreMap& self, const CoreRobot& robot) {
    return self.map->manipulator() == robot.manipulator;
  });
  map.def("locate", locate);
  map.def("boxes", boxes_of);
  map.def("undecided", undecided_boxes);
  map.def("scene", scene);
  map.def("save", save);
}

}  // namespace parallel_aspects::python
