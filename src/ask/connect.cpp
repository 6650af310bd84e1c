// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/connect.h"

#include "ask/question_parts.h"
#include "aspects/map/map_contents.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::ask {
namespace {

constexpr std::size_t modes_of_thorough_search = 8;  // which takes up to a second each

/// One question on its way to an answer.
class Connecting {
 public:
  Connecting(Session& session, const ConnectQuestion& question, const Control& control)
      : session_(session), question_(question), control_(control) {}

  Outcome<ConnectAnswer> run() {
    check();
    if (problems_.empty() && result_.slice) find_map();
    for (const WorkingMode& mode : modes_) {
      if (!problems_.empty() || control_.is_over()) break;
      result_.answers.push_back(connection(mode));
    }
    return outcome_of(std::move(problems_), control_, std::move(result_));
  }

 private:
  const Manipulator& robot() const { return *session_.robot(); }

  void check() {
    result_.task_space = robot().task_space();
    result_.slice = session_.slice_of(question_.map);
    modes_ = question_.mode ? std::vector<WorkingMode>{*question_.mode} : working_modes(robot());
    result_.from = end("start", question_.start);
    result_.to = end("goal", question_.goal);
    if (robot().task_space() == TaskSpace::SE3 && !result_.slice && !question_.map.is_default())
      problems_.push_back({ProblemKind::robot, "resolution",
                           "{resolution} and {load} are of a map of boxes, and in SE3 there is none",
                           "leave them out"});
    if (!problems_.empty() || !result_.slice) return;
    const double first = put_onto_slice(*result_.slice, robot(), "start", result_.from, problems_),
                 second = put_onto_slice(*result_.slice, robot(), "goal", result_.to, problems_);
    result_.moved_onto_slice = std::max(first, second);
  }

  Pose end(const std::string& field, const std::optional<Pose>& pose) {
    if (!pose)
      problems_.push_back({ProblemKind::missing, field, "{" + field + "} is required", "give a pose"});
    return pose.value_or(Pose());
  }

  /// Null where none is asked; a map is made when something is not proved without it.
  const AspectMap* find_map() {
    if (!map_ && has_map() && problems_.empty())
      map_ = session_.map(question_.map, modes_, control_, problems_).map;
    return map_.get();
  }

  // Maps of one or two degrees of freedom are quick; others are made where they are asked for.
  bool has_map() const {
    if (question_.brief && !result_.slice) return session_.known_map() != nullptr;
    return result_.slice || session_.known_map() || !question_.map.is_default() ||
           degrees_of_freedom(robot().task_space()) <= 2;
  }

  ConnectionInMode connection(const WorkingMode& mode) {
    ConnectionInMode found{mode, result_.slice ? in_slice(mode) : compared(mode), {}, {}, {}};
    if (found.comparison.path.size() > 1 && !result_.slice) measure(found);
    if (found.comparison.answer != SameAspect::no && !question_.brief && find_map() != nullptr)
      found.bottleneck = {question_.index,
                          find_bottleneck(*map_, mode, result_.from, result_.to, question_.index, {},
                                          control_.begin("Looking for the bottleneck."))};
    return found;
  }

  AspectComparison compared(const WorkingMode& mode) {
    const PoseInMode first{result_.from, mode}, second{result_.to, mode};
    AspectComparison found = same_aspect(*session_.certifier(), first, second);
    if (found.searched_sign == 0) return found;
    const auto over = session_.roadmap(question_.roadmap.options({mode}), control_, problems_);
    if (!over) return found;
    found = same_aspect(*over, first, second, SearchEffort::brief);
    if (found.searched_sign != 0 && find_map() != nullptr) ask_map(*map_, first, second, found);
    const bool is_open = found.searched_sign != 0 && found.answer == SameAspect::unknown;
    if (is_open && (question_.brief || modes_.size() <= modes_of_thorough_search))
      found = same_aspect(*over, first, second);
    return found;
  }

  // Paths stay in the slice, so that roadmaps are of no use.
  AspectComparison in_slice(const WorkingMode& mode) const {
    if (!map_) return {};  // cancelled or refused
    const Location first = map_->locate(result_.from, mode), second = map_->locate(result_.to, mode);
    for (const LocationStatus status : {first.status, second.status}) {
      if (status == LocationStatus::outside)
        return {SameAspect::no, "One of the poses is proved to lie in no aspect of the slice.", {}, 0};
      if (status == LocationStatus::not_mapped)
        return {SameAspect::unknown, "One of the poses lies outside of the slice.", {}, 0};
    }
    if (!first || !second)
      return {SameAspect::unknown,
              "One of the poses is closer to a singularity or a limit than the map can decide.",
              {},
              0};
    if (first.aspect == second.aspect)
      return {SameAspect::yes, "The map of the slice proves it, by a path within the slice.", {}, 0};
    if (!may_be_one(*map_, first.aspect, second.aspect))
      return {SameAspect::no, "The map proves them separate within the slice.", {}, 0};
    return {SameAspect::unknown, "The map of the slice neither joins them nor proves them separate.", {}, 0};
  }

  void measure(ConnectionInMode& found) const {
    const PathMeasure measured = measure_path(session_.robot(), found.comparison.path, found.mode);
    found.clearance = measured.clearance;
    found.narrowest = measured.narrowest;
  }

  Session& session_;
  const ConnectQuestion& question_;
  const Control& control_;
  std::vector<WorkingMode> modes_;
  std::shared_ptr<const AspectMap> map_;  // null where none is asked
  ConnectAnswer result_;
  ProblemList problems_;
};

}  // namespace

Outcome<ConnectAnswer> answer(Session& session, const ConnectQuestion& question, const Control& control) {
  return Connecting(session, question, control).run();
}

}  // namespace parallel_aspects::ask
