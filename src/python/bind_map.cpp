// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_pictures.h"

#include "python/arrays.h"
#include "python/asking.h"
#include "python/bindings.h"
#include <pybind11/stl.h>
#include <utility>

namespace parallel_aspects::python {
namespace {

namespace py = pybind11;

/// Which map.
struct MapKeywords {
  MapOptions options;
  std::vector<ask::NamedRange> region;
};

template <class Visit>
void describe(Visit& visit, MapKeywords& keywords) {
  visit({"resolution", "", ""}, keywords.options.resolution);
  visit({"region", "", ""}, keywords.region);
  visit({"slice", "", ""}, keywords.options.slice);
  visit({"modes", "", ""}, keywords.options.modes);
}

MapOptions map_options(const Manipulator& manipulator, const py::dict& keywords) {
  const auto asked = read_question<MapKeywords>(manipulator, keywords);
  MapOptions options = asked.options;
  auto names = options.slice ? coordinate_names(*options.slice) : coordinate_names(manipulator.task_space());
  names.resize(options.slice ? options.slice->free_positions() : directions(manipulator.task_space()));
  ask::ProblemList problems;
  if (!asked.region.empty()) options.region = ask::box_of("region", names, asked.region, problems);
  if (!problems.empty()) throw InvalidDescription(texts_of(problems, ask::plain_name));
  return options;
}

CoreMap require(MapResult result) {
  if (!result) throw InvalidDescription({result.message});
  return CoreMap(std::move(result.map));
}

CoreMap compute(const CoreRobot& robot, const py::dict& keywords, unsigned threads, int extra_levels,
                bool complete, const py::object& progress) {
  MapOptions options = map_options(*robot.manipulator, keywords);
  options.threads = threads;
  options.extra_levels = extra_levels;
  options.complete = complete;
  return require(run_long(progress, [&](const MapControl& control) {
    return compute_aspect_map(robot.manipulator, options, control);
  }));
}

CoreMap load_file(const CoreRobot& robot, const std::string& file, const py::dict& keywords) {
  const MapOptions options = map_options(*robot.manipulator, keywords);
  return require(
      run_long(py::none(), [&](const MapControl&) { return load_map(robot.manipulator, options, file); }));
}

void save(const CoreMap& map, const std::string& file) {
  const SaveResult result = run_long(py::none(), [&](const MapControl&) { return save_map(*map.map, file); });
  if (!result) throw InvalidDescription({result.message});
}

py::dict aspect_dict(const CoreMap& map, const Aspect& aspect) {
  py::dict result;
  result["id"] = aspect.id;
  result["mode"] = to_string(aspect.mode);
  result["determinant_sign"] = aspect.determinant_sign;
  result["measure"] = aspect.measure;
  result["measure_lower"] = aspect.measure_lower;
  result["measure_upper"] = aspect.measure_upper;
  result["boxes"] = aspect.inside_leaves;
  result["deepest"] = array_of(map.robot().task_space(), aspect.deepest);
  result["clearance"] = aspect.deepest_clearance;
  result["unresolved_with"] = aspect.unresolved_with;
  return result;
}

py::list aspects_of(const CoreMap& map) {
  py::list result;
  for (const Aspect& aspect : map.map->aspects()) result.append(aspect_dict(map, aspect));
  return result;
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

py::object region_of(const CoreMap& map) {
  const Box region = map.map->region();
  return array_of({region}, region.dimension)[py::int_(0)];
}

const char* name_of(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::parallel:
      return "parallel";
    case BoundaryKind::serial:
      return "serial";
    case BoundaryKind::limit:
      return "limit";
    case BoundaryKind::passive_limit:
      return "passive_limit";
    case BoundaryKind::cone:
      return "cone";
    case BoundaryKind::self_collision:
      return "self_collision";
    case BoundaryKind::obstacle:
      return "obstacle";
    case BoundaryKind::workspace:
      return "workspace";
    case BoundaryKind::margin:
      break;
  }
  return "margin";
}

/// The plane that is drawn: all there is in T2, else at that phi, z or torsion, or the slice of the map.
PoseSlice plane_of(const CoreMap& map, double level) {
  if (!map.map->slice()) {
    if (map.robot().task_space() == TaskSpace::T1)
      throw InvalidDescription(
          {"The map is of a line; there is no plane to draw. boxes(aspect) has its ranges."});
    return {map.robot().task_space(), level};
  }
  if (map.map->slice()->dimension() != 2)
    throw InvalidDescription(
        {"The slice of the map has not two free coordinates; only planes are drawn. Map a slice with two."});
  return {map.robot(), *map.map->slice()};
}

Array points_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<TaskVector> rows(points.begin(), points.end());
  return array_of(rows, 2);
}

/// Polygons of each aspect and lines by kind, of one working mode in a plane.
py::dict trace(const CoreMap& map, const py::object& signs, double level, int cells) {
  if (cells < 2 || cells > 10'000)
    throw InvalidDescription({"cells is " + std::to_string(cells) + "; give 2 to 10000."});
  const WorkingMode mode = mode_of("mode", map.robot(), signs);
  const PoseSlice plane = plane_of(map, level);
  const auto picture = run_long(py::none(), [&](const MapControl&) {
    return trace_slice(*map.map, mode, plane, slice_bounds(*map.map), cells);
  });
  py::list polygons, lines;
  for (const BoundarySliver& sliver : picture.slivers)
    polygons.append(py::make_tuple(sliver.aspect, points_of(sliver.corners)));
  for (const BoundarySegment& segment : picture.segments)
    lines.append(py::make_tuple(name_of(segment.kind), points_of({segment.from, segment.to})));
  py::dict result;
  result["polygons"] = polygons;
  result["lines"] = lines;
  return result;
}

}  // namespace

void bind_map(RobotClass& robot, MapClass& map) {
  robot.def("map", compute);
  robot.def("load_map", load_file);
  const auto property = [&map](const char* name, auto get) {
    map.def_property_readonly(name, [get](const CoreMap& self) { return get(*self.map); });
  };
  property("coordinates", [](const AspectMap& m) { return m.coordinates(); });
  property("unit", [](const AspectMap& m) { return m.unit(); });
  property("resolution", [](const AspectMap& m) { return m.resolution(); });
  property("proved_count", [](const AspectMap& m) { return m.proved_count(); });
  property("count_at_most", [](const AspectMap& m) { return m.count_at_most(); });
  property("unresolved", [](const AspectMap& m) { return m.unresolved(); });
  property("measure_undecided", [](const AspectMap& m) { return m.measure_undecided(); });
  property("seconds", [](const AspectMap& m) { return m.seconds(); });
  map.def_property_readonly("region", region_of);
  map.def_property_readonly("aspects", aspects_of);
  map.def_property_readonly("working_modes", [](const CoreMap& self) {
    std::vector<std::string> texts;
    for (const WorkingMode& mode : self.map->working_modes()) texts.push_back(to_string(mode));
    return texts;
  });
  map.def("locate", locate);
  map.def("boxes", boxes_of);
  map.def("undecided", undecided_boxes);
  map.def("trace", trace);
  map.def("save", save);
}

}  // namespace parallel_aspects::python
