// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_contents.h"
#include "model/linear_algebra.h"
#include "model/message_text.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "tools/report/answer_json.h"
#include "tools/report/basins_report.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

// An aspect with a smaller share of the largest is not listed by itself.
constexpr double small_share = 0.01;

bool holds_joint(const AspectMap& map) { return map.slice() && map.slice()->joint; }

/// Where a joint is held, with as many digits as put the pose back onto the slice.
std::string pose_text(const AspectMap& map, const Pose& pose) {
  constexpr int digits_on_slice = 10;
  std::string text;
  const PoseCoordinates coordinates = pose_coordinates(map.manipulator()->task_space(), pose);
  for (const double coordinate : coefficients_of(coordinates))
    text += (text.empty() ? "(" : ", ") +
            (holds_joint(map) ? number_text(coordinate, digits_on_slice) : shown_briefly(coordinate));
  return text + ")";
}

std::string bounds_text(const Box& box) {
  std::string text;
  for (std::size_t i = 0; i < box.dimension; ++i)
    text += (i == 0 ? "" : " x ") + std::string("[") + shown_briefly(box.lower[i]) + ", " +
            shown_briefly(box.upper[i]) + "]";
  return text;
}

/// Aspects that are a line each, and those that are one line together.
struct ListedAspects {
  std::vector<Aspect> shown, small;
};

ListedAspects listed_aspects(const AspectMap& map, bool all) {
  double largest = 0.0;
  for (const Aspect& aspect : map.aspects()) largest = std::max(largest, aspect.measure);
  ListedAspects listed;
  for (const Aspect& aspect : map.aspects()) {
    const bool is_small = !all && aspect.measure < small_share * largest;
    (is_small ? listed.small : listed.shown).push_back(aspect);
  }
  return listed;
}

// Where orientations are searched alone, boxes have no bounds to show.
std::string aspect_table(const AspectMap& map, const std::vector<Aspect>& aspects, const MapBasins* basins) {
  const bool bounded = map.region().dimension > 0;
  std::vector<std::string> titles{">id",       "working mode", "det A",   ">measure [" + map.unit() + "]",
                                  ">at least", ">at most",     ">leaves", "deepest pose",
                                  ">clearance"};
  if (bounded) titles.insert(titles.end() - 2, holds_joint(map) ? "bounds of direction and phi" : "bounds");
  if (basins != nullptr)
    titles.emplace_back(basins->index == ParallelIndex::normalised ? "largest index" : "largest |det A|");
  TextTable table(titles);
  for (const Aspect& aspect : aspects) {
    std::vector<std::string> cells{std::to_string(aspect.id),
                                   to_string(aspect.mode),
                                   shown_sign(aspect.determinant_sign),
                                   shown(aspect.measure),
                                   shown(aspect.measure_lower),
                                   shown(aspect.measure_upper),
                                   std::to_string(aspect.inside_leaves),
                                   pose_text(map, aspect.deepest),
                                   shown_briefly(aspect.deepest_clearance)};
    if (bounded) cells.insert(cells.end() - 2, bounds_text(aspect.bounds));
    if (basins != nullptr)
      cells.push_back(shown_range(basins->deepest[static_cast<std::size_t>(aspect.id - 1)]));
    table.add(std::move(cells));
  }
  return table.text();
}

std::string small_text(const AspectMap& map, const std::vector<Aspect>& small) {
  if (small.empty()) return "";
  double sum = 0.0;
  std::size_t separate = 0;
  for (const Aspect& aspect : small) {
    sum += aspect.measure;
    separate += aspect.unresolved_with.empty() ? 1 : 0;
  }
  return "and " + std::to_string(small.size()) + " more, each below 1 % of the largest, together " +
         shown(sum) + ' ' + map.unit() + "; " + std::to_string(separate) +
         " of them proved separate from all others; --all lists them\n";
}

/// Pairs of those that are listed, and how many pairs there are with others.
std::string unresolved_text(const AspectMap& map, const std::vector<Aspect>& small) {
  if (map.unresolved().empty()) return "none; all are proved separate";
  const auto is_small = [&](int id) {
    return std::any_of(small.begin(), small.end(), [&](const Aspect& each) { return each.id == id; });
  };
  std::string text;
  std::size_t with_small = 0;
  for (const auto& [first, second] : map.unresolved()) {
    if (is_small(first) || is_small(second))
      ++with_small;
    else
      text += (text.empty() ? "" : ", ") + std::to_string(first) + " with " + std::to_string(second);
  }
  if (with_small == 0) return text;
  return text + (text.empty() ? "" : ", and ") + counted(with_small, "pair") + " with aspects not listed";
}

std::string region_text(const AspectMap& map) {
  return map.region().dimension == 0 ? "" : ", region " + bounds_text(map.region());
}

/// Which symmetries were used, and what for.
std::string symmetry_text(const AspectMap& map) {
  if (!map.symmetry_use() || map.symmetry_use()->motions.empty()) return "";
  std::string text;
  for (const std::string& motion : map.symmetry_use()->motions) text += (text.empty() ? " " : "; ") + motion;
  return "symmetry" + text + ": components of " +
         counted(map.symmetry_use()->computed_modes, "working mode") + " computed\n";
}

/// How many there are aspects of, and where not all were examined, how many the robot has.
std::string mode_count(const AspectMap& map) {
  const std::size_t found = map.working_modes().size(), all = working_modes(*map.manipulator()).size();
  return map.contents().modes.size() < all ? std::to_string(found) + " of " + counted(all, "working mode")
                                           : counted(found, "working mode");
}

std::string hiding_text(const AspectMap& map) {
  if (map.count_at_most()) return "; no further aspect is there";
  const bool may_be_excluded = !map.slice() && !map.contents().complete;
  return std::string("; smaller aspects may hide there") +
         (may_be_excluded ? ", which --complete searches" : "");
}

std::string map_text(const AspectMap& map, bool all_aspects, const MapBasins* basins) {
  std::string text = map.manipulator()->name() + ": " + aspect_count(map) + "; " + mode_count(map) + "\n";
  if (map.slice())
    text += "slice " + to_string(*map.slice()) +
            ": aspects of the slice, of which two may be joined outside of it\n";
  text += tolerance_text(*map.manipulator());
  text += "task space " + std::string(name(map.manipulator()->task_space())) + region_text(map) +
          ", resolution " + shown(map.resolution()) + ", " + shown(map.seconds()) + " s\n" +
          symmetry_text(map) + "\n";
  const ListedAspects listed = listed_aspects(map, all_aspects);
  text += aspect_table(map, listed.shown, basins) + small_text(map, listed.small);
  text += "\npairs that could be one aspect: " + unresolved_text(map, listed.small) + "\n";
  text += "undecided, over all working modes: " + shown(map.measure_undecided()) + " " + map.unit() +
          hiding_text(map) + "\n";
  return text;
}

}  // namespace

nlohmann::json json_margins(const Margins& margins) {
  nlohmann::json object = nlohmann::json::object();
  for (const auto& [name, value] : ask::margins_of(margins)) object[name] = json_number(value);
  return object;
}

std::string aspect_count(const AspectMap& map) {
  const std::size_t proved = map.proved_count(), components = map.aspects().size();
  const std::size_t most = map.count_at_most().value_or(components);
  const std::string where = is_cut_by_region(map) ? " in the region" : "";
  if (most == proved && map.count_at_most())
    return "exactly " + counted(proved, "aspect") + where + " (proved)";
  const std::string found = map.unresolved().empty()
                                ? "all proved distinct"
                                : std::to_string(proved) + " proved distinct; " +
                                      counted(map.unresolved().size(), "pair") + " unresolved";
  return (most == proved ? "at least " : std::to_string(proved) + " to ") + counted(most, "aspect") + where +
         " (" + counted(components, "component") + "; " + found + ")";
}

namespace {

std::string leg_name(const AspectMap& map, const Neighbours& pair) {
  return map.manipulator()->leg(pair.leg).name;
}

std::string touching_text(const AspectMap& map, const std::vector<Neighbours>& neighbours) {
  if (neighbours.empty()) return "\naspects that touch: none were found\n";
  TextTable table({">aspect", ">touches", "through", "", "near"});
  for (const Neighbours& pair : neighbours)
    table.add({std::to_string(pair.first), std::to_string(pair.second),
               pair.crossing == Crossing::serial ? "B_jj = 0 of " + leg_name(map, pair) : "det A = 0",
               pair.proved ? "proved" : "possible", to_string(map.manipulator()->task_space(), pair.pose)});
  return "\naspects that touch:\n" + table.text();
}

}  // namespace

Report report_map(const ask::MapAnswer& answer, const MapReportOptions& options) {
  const AspectMap& map = *answer.map;
  const MapBasins* basins = answer.basins ? &*answer.basins : nullptr;
  const Report bounds = report_bounds(map, options.verbose);
  Report report{answer_json(*map.manipulator(), answer), map_text(map, options.all_aspects, basins)};
  report.json["mechanism"] = map.manipulator()->name();
  report.json.update(bounds.json);
  if (basins != nullptr) report.text += pairs_text(map, *basins);
  report.text += bounds.text;
  if (!answer.no_aspect.empty()) report.text += "\nnote: " + answer.no_aspect + "\n";
  if (basins != nullptr && !basins->basins.empty()) report.text += persistence_text(map, *basins);
  return report;
}

std::string neighbours_text(const ask::MapAnswer& answer) {
  if (!answer.neighbours) return "";
  const std::string text = touching_text(*answer.map, *answer.neighbours);
  if (!answer.neighbours_not_across) return text;
  return text + "those across B_jj = 0 of " +
         answer.map->manipulator()->leg(answer.neighbours_not_across->index).name +
         ", whose joint is held, are not searched\n";
}

}  // namespace parallel_aspects::tools
