// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/uniqueness_report.h"

#include "model/angles.h"
#include "model/message_text.h"
#include "tools/report/report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

bool has_modes(const Manipulator& robot) { return working_modes(robot).size() > 1; }

/// What the map is of: aspects, or components of a slice.
std::string part_name(const AspectMap& map, const std::string& before) {
  return before + (map.slice() ? "component" : "aspect");
}

/// Why there are none.
std::string no_components_text(const AspectMap& map) {
  const double undecided = map.measure_undecided();
  if (undecided > 0.0)
    return "No pose is proved to lie in one; " + shown_bound(undecided, Side::above) + " " + map.unit() +
           " are undecided, over all working modes.\n";
  return "Proved: no pose is reached within the limits.\n";
}

std::string components_text(const AspectMap& map) {
  if (map.aspects().empty()) return no_components_text(map);
  TextTable table({part_name(map, ">"), "working mode", "det A", ">measure [" + map.unit() + "]"});
  for (const Aspect& aspect : map.aspects())
    table.add({std::to_string(aspect.id), to_string(aspect.mode), aspect.determinant_sign > 0 ? "+" : "-",
               shown_briefly(aspect.measure)});
  return table.text();
}

/// A column for each actuated joint, by its name and unit.
std::vector<std::string> joint_titles(const Manipulator& robot) {
  std::vector<std::string> titles;
  for (const Leg& leg : robot.legs())
    titles.push_back(">" + leg.actuated_joint + " [" + joint_unit(leg) + "]");
  return titles;
}

std::vector<std::string> joint_cells(const JointVector& actuated) {
  std::vector<std::string> cells;
  for (Eigen::Index j = 0; j < actuated.size(); ++j) cells.push_back(fixed_number_text(actuated[j], 6));
  return cells;
}

std::vector<std::string> cusp_titles(const Manipulator& robot, bool parts) {
  std::vector<std::string> titles = joint_titles(robot);
  if (parts) titles.emplace_back(">component");
  if (has_modes(robot)) titles.emplace_back("working mode");
  titles.emplace_back("pose");
  return titles;
}

/// As in the list of components; `?` where the map cannot decide.
std::string shown_aspect(int aspect) { return aspect == 0 ? "?" : std::to_string(aspect); }

/// With the parts of the slice that they belong to, where there are some.
std::string cusps_text(const Manipulator& robot, const std::vector<Cusp>& cusps, bool complete, bool parts) {
  const std::string text =
      counted(cusps.size(), "cusp") + ", " + (complete ? "proved to be all" : "there may be more") + "\n";
  if (cusps.empty()) return text;
  TextTable table(cusp_titles(robot, parts));
  for (const Cusp& cusp : cusps) {
    std::vector<std::string> cells = joint_cells(cusp.actuated);
    if (parts) cells.push_back(shown_aspect(cusp.aspect));
    if (has_modes(robot)) cells.push_back(to_string(cusp.mode));
    cells.push_back(to_string(robot.task_space(), cusp.pose));
    table.add(std::move(cells));
  }
  return text + table.text();
}

std::string cusps_text(const Uniqueness& uniqueness) {
  if (!uniqueness.map->slice() && !uniqueness.at_most_one_a_sign)
    return "Cusps form curves; --slice lists those of a value of an actuated joint, --cusps-over follows "
           "them.\n";
  return cusps_text(*uniqueness.map->manipulator(), uniqueness.cusps, uniqueness.cusps_complete,
                    !uniqueness.map->aspects().empty());
}

std::string nodes_text(const Uniqueness& uniqueness) {
  if (!uniqueness.has_nodes) return "";
  const Manipulator& robot = *uniqueness.map->manipulator();
  std::string text = "\n" + counted(uniqueness.nodes.size(), "node") +
                     ", where two pairs of solutions meet, " +
                     (uniqueness.nodes_complete ? "proved to be all" : "there may be more") + "\n";
  if (uniqueness.nodes.empty()) return text;
  std::vector<std::string> titles = joint_titles(robot);
  titles.emplace_back("one pose");
  titles.emplace_back("the other");
  TextTable table(titles);
  for (const SolutionNode& node : uniqueness.nodes) {
    std::vector<std::string> cells = joint_cells(node.actuated);
    for (const Pose& pose : node.poses) cells.push_back(to_string(robot.task_space(), pose));
    table.add(std::move(cells));
  }
  return text + table.text();
}

/// With a column for the working mode in front, where numbers are those of each.
std::vector<std::string> titles_with_mode(const SolutionNumbers& numbers, std::vector<std::string> titles) {
  if (numbers.by_mode) titles.insert(titles.begin(), "working mode");
  return titles;
}

std::vector<std::string> cells_with_mode(const WorkingMode& mode, std::vector<std::string> cells) {
  if (!mode.signs().empty()) cells.insert(cells.begin(), to_string(mode));
  return cells;
}

/// Of angles whose limits hold more than a turn.
std::string turns_text(const Manipulator& robot) {
  std::string names;
  for (const Leg& leg : robot.legs())
    if (leg.actuated_by_angle() && leg.limits.upper - leg.limits.lower > full_turn &&
        std::isfinite(leg.limits.upper - leg.limits.lower))
      names += (names.empty() ? "" : ", ") + leg.actuated_joint;
  return names.empty()
             ? ""
             : "Each angle of " + names + " counts once, though its limits hold more than a turn.\n";
}

std::string regions_text(const Manipulator& robot, const SolutionNumbers& uniqueness) {
  if (!uniqueness.has_regions) return "";
  const std::string& unit = uniqueness.region_unit;
  TextTable table(
      titles_with_mode(uniqueness, {">solutions", ">measure [" + unit + "]", ">at least", ">at most"}));
  for (const SolutionRegion& region : uniqueness.regions)
    table.add(cells_with_mode(region.mode, {std::to_string(region.solutions), shown_briefly(region.measure),
                                            shown_bound(region.measure_lower, Side::below),
                                            shown_bound(region.measure_upper, Side::above)}));
  return "\nactuated values by their number of direct solutions" +
         std::string(uniqueness.by_mode ? " in each working mode" : "") + ", which is not proved on " +
         shown_bound(uniqueness.measure_unknown, Side::above) + " " + unit +
         (uniqueness.by_mode ? " over all working modes" : "") + "\n" +
         (uniqueness.regions.empty() ? "" : table.text()) + turns_text(robot);
}

/// The number of direct solutions in each aspect, by its id; `?` where the map cannot decide.
std::string solutions_by_aspect(const BasicComponent& component) {
  std::map<int, std::size_t> counts;
  for (const int aspect : component.aspects) ++counts[aspect];
  std::string text;
  for (const auto& [aspect, count] : counts)
    text += (text.empty() ? "" : ", ") + shown_aspect(aspect) + ": " + std::to_string(count);
  return text;
}

// Smaller sets, of which there are many beside what is not decided, are not listed. Nor have they basic
// regions.
constexpr double least_share = 1e-4;

/// Sets, which are sorted: those that are not tiny.
std::size_t worth_listing(const std::vector<BasicComponent>& components) {
  double all = 0.0;
  for (const BasicComponent& each : components) all += each.measure;
  std::size_t listed = 0;
  while (listed < components.size() && components[listed].measure >= least_share * all) ++listed;
  return listed;
}

// Longer lists are cut to so many; JSON has all of them.
constexpr std::size_t longest_list = 40, most_of_long_list = 12;

/// Which of these are listed, by index: all, or the largest.
template <class Item>
std::vector<std::size_t> listed_of(const std::vector<Item>& items) {
  std::vector<std::size_t> result(items.size());
  std::iota(result.begin(), result.end(), std::size_t{0});
  if (items.size() <= longest_list) return result;
  std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) {
    return items[a].measure_lower > items[b].measure_lower;
  });
  result.resize(most_of_long_list);
  std::sort(result.begin(), result.end());
  return result;
}

std::string left_out_text(std::size_t all, std::size_t listed, const std::string& what) {
  return listed < all ? counted(all - listed, "other " + what) + " left out\n" : "";
}

std::string basic_components_text(const Uniqueness& uniqueness) {
  if (!uniqueness.has_regions) return "";
  const auto& components = uniqueness.basic_components;
  if (components.empty()) return "";
  const std::string& unit = uniqueness.region_unit;
  std::vector<std::string> titles{">set", ">solutions", "by " + part_name(*uniqueness.map, ""),
                                  ">measure [" + unit + "]"};
  for (std::string& title : joint_titles(*uniqueness.map->manipulator())) titles.push_back(std::move(title));
  TextTable table(titles);
  const std::size_t worth = worth_listing(components);
  const std::size_t listed = worth > longest_list ? most_of_long_list : worth;
  for (std::size_t i = 0; i < listed; ++i) {
    std::vector<std::string> cells{std::to_string(i + 1), std::to_string(components[i].solutions.size()),
                                   solutions_by_aspect(components[i]), shown_briefly(components[i].measure)};
    for (std::string& cell : joint_cells(components[i].inside)) cells.push_back(std::move(cell));
    table.add(std::move(cells));
  }
  double rest = 0.0;
  for (std::size_t i = listed; i < components.size(); ++i) rest += components[i].measure;
  const std::string left_out = counted(components.size() - listed, "smaller set") + " left out, " +
                               shown_briefly(rest) + " " + unit + " in all\n";
  return "\nconnected sets of actuated values with one number of direct solutions, and values in each\n" +
         table.text() + (listed < components.size() ? left_out : "");
}

/// The set that a region lies over: of several working modes as numbered in each.
std::string set_below(const Uniqueness& uniqueness, const BasicRegion& region) {
  if (ask::are_of_all_modes(uniqueness)) return std::to_string(region.over + 1);
  const auto below = ask::component_below(uniqueness, region);
  return below ? std::to_string(*below + 1) : "?";
}

/// What lies over each connected set of actuated values.
std::string basic_regions_text(const Uniqueness& uniqueness) {
  if (!uniqueness.has_domains || uniqueness.basic_regions.empty()) return "";
  const Manipulator& robot = *uniqueness.map->manipulator();
  TextTable table({">basic region", part_name(*uniqueness.map, ">"),
                   ask::are_of_all_modes(uniqueness) ? ">over set of its mode" : ">over set",
                   ">actuated values [" + uniqueness.region_unit + "], at least", "unique", "a pose of it",
                   ">domains"});
  const std::vector<std::size_t> listed = listed_of(uniqueness.basic_regions);
  for (const std::size_t i : listed) {
    const BasicRegion& region = uniqueness.basic_regions[i];
    table.add({std::to_string(i + 1), std::to_string(region.aspect), set_below(uniqueness, region),
               shown_bound(region.measure_lower, Side::below), region.is_unique ? "proved" : "not proved",
               to_string(robot.task_space(), region.pose), std::to_string(uniqueness.domains_of(i).size())});
  }
  return "\nbasic regions, each a connected set of poses over a connected set of actuated values\n" +
         table.text() + left_out_text(uniqueness.basic_regions.size(), listed.size(), "region");
}

std::string regions_of_domain(const UniquenessDomain& domain) {
  std::string text;
  for (const std::size_t region : domain.basic_regions)
    text += (text.empty() ? "" : ", ") + std::to_string(region + 1);
  return text;
}

std::string domains_text(const Uniqueness& uniqueness) {
  if (!uniqueness.has_domains || uniqueness.domains.empty()) return "";
  TextTable table({">domain", part_name(*uniqueness.map, ">"), ">basic regions",
                   ">actuated values [" + uniqueness.region_unit + "], at least"});
  const std::vector<std::size_t> listed = listed_of(uniqueness.domains);
  for (const std::size_t i : listed) {
    const UniquenessDomain& domain = uniqueness.domains[i];
    table.add({std::to_string(i + 1), std::to_string(domain.aspect), regions_of_domain(domain),
               shown_bound(domain.measure_lower, Side::below)});
  }
  return "\nuniqueness domains, which overlap" +
         std::string(uniqueness.domains_complete ? "" : " and of which there are more") + "\n" +
         table.text() + left_out_text(uniqueness.domains.size(), listed.size(), "domain");
}

std::string headline(const Uniqueness& uniqueness) {
  const AspectMap& map = *uniqueness.map;
  std::string text = map.manipulator()->name();
  if (map.slice()) text += ", " + to_string(*map.slice());
  text += ": " + counted(map.aspects().size(), part_name(map, "")) + "\n";
  if (uniqueness.at_most_one_a_sign)
    text +=
        "Each is a uniqueness domain: for given actuated values there are at most two poses, with opposite "
        "signs of det A.\n";
  return text;
}

}  // namespace

std::string uniqueness_text(const Manipulator& /*robot*/, const std::shared_ptr<const Uniqueness>& found) {
  const Uniqueness& uniqueness = *found;
  const AspectMap& map = *uniqueness.map;
  return headline(uniqueness) + '\n' + components_text(map) + '\n' + cusps_text(uniqueness) +
         nodes_text(uniqueness) + regions_text(*map.manipulator(), uniqueness) +
         basic_components_text(uniqueness) + basic_regions_text(uniqueness) + domains_text(uniqueness);
}

std::string uniqueness_text(const Manipulator& robot, const ask::CuspsInSlice& answer) {
  const CuspList& found = answer.found;
  const std::string why =
      found.leaves_curves
          ? "Not decided are curves of poses, as those along which the platform can move while all actuated "
            "joints stand.\n"
          : "";
  return robot.name() + ", " + answer.joint + " = " + number_text(answer.held.value) + " " +
         joint_unit(robot.leg(answer.held.leg)) + "\n\n" +
         cusps_text(robot, found.cusps, found.complete, false) + why + regions_text(robot, answer.numbers);
}

}  // namespace parallel_aspects::tools
