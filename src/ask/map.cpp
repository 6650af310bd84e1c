// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/map.h"

#include "ask/question_parts.h"
#include "aspects/map/empty_map.h"
#include "draw/plane/palette.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::ask {
namespace {

std::vector<MappedAspect> aspects_of(const AspectMap& map) {
  const std::vector<Rgb> colors = aspect_colors(map.aspects());
  std::vector<MappedAspect> found;
  for (const Aspect& each : map.aspects())
    found.push_back(
        {each, map.unit(), ranges_of(map.coordinates(), each.bounds), color_text(colors[found.size()]), {}});
  return found;
}

/// The leg across whose singularity no neighbours are searched for, since its joint is held.
std::optional<LegIndex> held_leg(const AspectMap& map) {
  if (!map.slice() || !map.slice()->joint) return std::nullopt;
  const std::size_t leg = map.slice()->joint->leg;
  return only_if(map.manipulator()->leg(leg).kind().moves_proximal_point, LegIndex{leg});
}

/// One question on its way to an answer.
class Mapping {
 public:
  Mapping(Session& session, const MapQuestion& question, const Control& control)
      : session_(session), question_(question), control_(control) {}

  Outcome<MapAnswer> run() {
    check();
    if (problems_.empty()) has_map() ? find_map() : find_roadmap();
    return outcome_of(std::move(problems_), control_, std::move(result_));
  }

 private:
  bool has_map() const { return ask::has_map(options_.slice, *session_.robot()); }

  void find_map() {
    const FoundMap found = session_.map_of(options_, question_.source, control_, problems_);
    if (!found.map) return;
    result_ = answer_of(found.map);
    result_.loaded = found.loaded;
    result_.no_aspect = why_empty(*found.map, control_.begin("Looking for why there is no aspect."));
    add_basins(*found.map);
    if (!question_.neighbours) return;
    result_.neighbours = find_neighbours(*found.map, control_.begin("Looking for neighbours."));
    result_.neighbours_not_across = held_leg(*found.map);
  }

  void find_roadmap() {
    RoadmapOptions options = question_.roadmap.options({});
    options.region = options_.region;
    options.threads = options_.threads;
    if (auto roadmap = session_.roadmap(options, control_, problems_))
      result_ = answer_of(std::move(roadmap));
  }

  void refuse(ProblemKind kind, const std::string& field, std::string fault, std::string remedy) {
    problems_.push_back({kind, field, "{" + field + "} " + std::move(fault), std::move(remedy)});
  }

  void check() {
    const TaskSpace space = session_.robot()->task_space();
    options_ = session_.options_for(question_.source, question_.modes);
    if (question_.threads) options_.threads = question_.threads->value;
    if (question_.extra_levels) options_.extra_levels = static_cast<int>(question_.extra_levels->value);
    options_.complete = question_.complete;
    options_.use_symmetry = !question_.no_symmetry;
    has_map() ? check_sources(true, question_.source, question_.roadmap, problems_) : refuse_boxes();
    if (options_.complete && options_.slice)
      refuse(ProblemKind::together, "complete", "is for maps of all poses, not for slices",
             "leave out one of the two");
    if (!question_.region.empty()) find_region(space);
  }

  /// What a roadmap does not have.
  void refuse_boxes() {
    const MapSource& source = question_.source;
    std::vector<std::string> given;
    for (const auto& [field, is_given] :
         std::vector<std::pair<std::string, bool>>{{"resolution", source.resolution.has_value()},
                                                   {"mode", !question_.modes.empty()},
                                                   {"load", !source.load.empty()},
                                                   {"save", !source.save.empty()},
                                                   {"extra_levels", question_.extra_levels.has_value()},
                                                   {"index", question_.index.has_value()},
                                                   {"complete", question_.complete},
                                                   {"neighbours", question_.neighbours},
                                                   {"no_symmetry", question_.no_symmetry},
                                                   {"persistence", question_.persistence}})
      if (is_given) given.push_back("{" + field + "}");
    if (given.empty()) return;
    const bool one = given.size() == 1;
    problems_.push_back(
        {ProblemKind::robot, "slice",
         enumerated(given) + (one ? " is" : " are") + " for maps of boxes, and in SE3 only slices have these",
         std::string("give {slice}, or leave ") + (one ? "it" : "them") + " out"});
  }

  void find_region(TaskSpace space) {
    const auto& slice = options_.slice;
    const bool of_joint = slice && slice->joint;
    std::vector<std::string> names = slice ? coordinate_names(*slice) : coordinate_names(space);
    names.resize(of_joint ? 0 : slice ? slice->free_positions() : directions(space));
    if (names.empty())
      refuse(ProblemKind::together, "region",
             std::string("is of positions, but here every ") + (of_joint ? "direction and " : "") +
                 "orientation is searched and no more",
             "leave it out");
    else
      options_.region = box_of("region", names, question_.region, problems_);
  }

  void add_basins(const AspectMap& map) {
    if (!question_.index) return;
    result_.basins =
        find_basins(map, *question_.index, question_.persistence ? BasinDetail::basins : BasinDetail::depths,
                    control_.begin("Measuring depths."));
    for (std::size_t i = 0; result_.basins && i < result_.aspects.size(); ++i)
      result_.aspects[i].deepest_index = result_.basins->deepest[i];
  }

  Session& session_;
  const MapQuestion& question_;
  const Control& control_;
  MapOptions options_;
  MapAnswer result_;
  ProblemList problems_;
};

}  // namespace

std::optional<std::vector<PairBottleneck>> MapAnswer::bottlenecks() const {
  if (!basins) return std::nullopt;
  std::vector<PairBottleneck> pairs;
  for (const std::vector<int>& pair : unresolved) pairs.push_back({pair, basins->bottlenecks[pairs.size()]});
  return pairs;
}

double SampledSide::largest_share() const {
  return static_cast<double>(component_sizes.front()) / static_cast<double>(samples);
}

namespace {

SampledSide sampled(const PoseRoadmap& roadmap, const RoadmapSide& side) {
  const Manipulator& robot = *roadmap.certifier().manipulator();
  std::vector<double> largest(side.component_sizes.size(), 0.0);
  for (std::size_t i = 0; i < side.poses.size(); ++i) {
    const Pose& pose = roadmap.poses()[side.poses[i]];
    double& known = largest[side.component[i]];
    known = std::max(known, parallel_index(robot, pose, inverse(robot, pose, side.mode).q));
  }
  return {side.mode, side.determinant_sign, side.poses.size(), side.component_sizes, std::move(largest)};
}

}  // namespace

MapAnswer answer_of(std::shared_ptr<const PoseRoadmap> roadmap) {
  MapAnswer answer;
  answer.task_space = roadmap->certifier().manipulator()->task_space();
  SampledAspects& result = answer.sampled.emplace();
  for (const RoadmapSide& side : roadmap->sides()) result.sides.push_back(sampled(*roadmap, side));
  result.roadmap = std::move(roadmap);
  return answer;
}

MapAnswer answer_of(std::shared_ptr<const AspectMap> map) {
  const Manipulator& robot = *map->manipulator();
  MapAnswer answer;
  answer.task_space = robot.task_space();
  answer.slice = map->slice();
  answer.region = ranges_of(map->coordinates(), map->region());
  answer.resolution = map->resolution();
  answer.seconds = map->seconds();
  answer.symmetry = map->symmetry_use();
  answer.unit = map->unit();
  answer.working_modes = map->working_modes();
  answer.aspects = aspects_of(*map);
  answer.proved_count = static_cast<int>(map->proved_count());
  if (map->count_at_most()) answer.count_at_most = static_cast<int>(*map->count_at_most());
  answer.cut_by_region = is_cut_by_region(*map);
  answer.indeterminate_leaves = static_cast<int>(map->indeterminate_leaves());
  for (const auto& [first, second] : map->unresolved()) answer.unresolved.push_back({first, second});
  answer.measure_undecided = map->measure_undecided();
  answer.margins = margins_of(robot.constraints().margins);
  answer.tolerance = robot.tolerance();
  answer.map = std::move(map);
  return answer;
}

Outcome<MapAnswer> answer(Session& session, const MapQuestion& question, const Control& control) {
  return Mapping(session, question, control).run();
}

}  // namespace parallel_aspects::ask
