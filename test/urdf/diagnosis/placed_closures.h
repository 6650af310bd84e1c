// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_URDF_DIAGNOSIS_PLACED_CLOSURES_H
#define PARALLEL_ASPECTS_TEST_URDF_DIAGNOSIS_PLACED_CLOSURES_H

#include "support/descriptions.h"
#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Robots whose loops are closed at places beside links, in the words of several dialects.
namespace parallel_aspects::test {

/// Two links and a place in each, "0 0 -0.4".
struct PlacedClosure {
  std::array<std::string, 2> links, places;

  std::string name() const { return links[0] + " - " + links[1]; }
};

using PlacedClosures = std::vector<PlacedClosure>;

inline const std::vector<std::string>& placed_dialects() {
  static const std::vector<std::string> dialects{"list", "drake", "loop_joint", "constraint", "weld"};
  return dialects;
}

inline std::string in_words_of(const std::string& dialect, const PlacedClosure& closure) {
  const auto& [links, places] = closure;
  if (dialect == "list") {
    const auto frame = [](const std::string& link, const std::string& place) {
      return "{link: " + link + ", xyz: [" + std::regex_replace(place, std::regex(" "), ", ") + "]}";
    };
    return "{frames: [" + frame(links[0], places[0]) + ", " + frame(links[1], places[1]) + "], type: point}";
  }
  if (dialect == "drake")
    return "<drake:ball_constraint><drake:ball_constraint_body_A name=\"" + links[0] +
           "\"/><drake:ball_constraint_p_AP value=\"" + places[0] +
           "\"/><drake:ball_constraint_body_B name=\"" + links[1] +
           "\"/><drake:ball_constraint_p_BQ value=\"" + places[1] + "\"/></drake:ball_constraint>";
  if (dialect == "loop_joint")
    return "<loop_joint name=\"" + closure.name() + "\" type=\"spherical\"><link1 link=\"" + links[0] +
           "\" xyz=\"" + places[0] + "\"/><link2 link=\"" + links[1] + "\" xyz=\"" + places[1] +
           "\"/></loop_joint>";
  return "<constraint name=\"" + closure.name() + "\" type=\"" + (dialect == "weld" ? "fixed" : "spherical") +
         "_joint\"><parent link=\"" + links[0] + "\"/><parent_origin xyz=\"" + places[0] +
         "\"/><child link=\"" + links[1] + "\"/><child_origin xyz=\"" + places[1] + "\"/></constraint>";
}

/// Of the Delta that is closed while all joints are zero.
inline PlacedClosures closures_of_delta() {
  return {{{"rod_1", "platform"}, {"0 0 -0.4", "0.05 0 0"}},
          {{"rod_2", "platform"}, {"0 0 -0.4", "-0.025 0.04330127019 0"}},
          {{"rod_3", "platform"}, {"0 0 -0.4", "-0.025 -0.04330127019 0"}}};
}

/// That Delta with these closures.
inline Description placed_delta(const std::string& dialect, const PlacedClosures& closures) {
  std::string urdf = source_file("test/data/at_zero/delta.urdf");
  for (const std::string element :
       {"<gazebo>[\\s\\S]*?</gazebo>", "<joint name=\"(end|anchor)_\\d\"[\\s\\S]*?</joint>",
        "<link name=\"(rod_end|ball)_\\d\"/>"})
    urdf = std::regex_replace(urdf, std::regex(element), "");
  std::string config =
      "mechanism: {base_link: base, operational_point: platform, actuated_joints: [motor_1, motor_2, "
      "motor_3]";
  std::string text;
  for (const PlacedClosure& closure : closures)
    text += (dialect == "list" && !text.empty() ? ", " : "") + in_words_of(dialect, closure);
  if (dialect == "list")
    config += ", closures: [" + text + "]";
  else
    urdf = replaced(urdf, "</robot>", text + "</robot>");
  return {urdf, config + "}\n"};
}

/// The closures after the remedies of a message; as they are where it has none that is understood.
inline PlacedClosures followed(PlacedClosures closures, const std::string& message) {
  const std::regex place(
      "write (?:xyz: \\[|xyz=\"|value=\")([^\\]\"]+)[\\]\"] in link '([^']+)' of closure '([^']+)'");
  for (std::sregex_iterator at(message.begin(), message.end(), place), end; at != end; ++at)
    for (PlacedClosure& closure : closures)
      for (const std::size_t side : {0, 1})
        if (closure.name() == (*at)[3].str() && closure.links[side] == (*at)[2].str())
          closure.places[side] = std::regex_replace((*at)[1].str(), std::regex(","), "");
  const std::regex exchange("exchange the second ends of closure '([^']+)' and closure '([^']+)'");
  for (std::sregex_iterator at(message.begin(), message.end(), exchange), end; at != end; ++at)
    for (PlacedClosure& one : closures)
      for (PlacedClosure& other : closures)
        if (one.name() == (*at)[1].str() && other.name() == (*at)[2].str() && &one != &other) {
          std::swap(one.links[1], other.links[1]);
          std::swap(one.places[1], other.places[1]);
          return closures;
        }
  return closures;
}

/// What people write in the place of "0.1 0 0.2": a sign, two numbers exchanged, millimetres.
inline std::vector<std::string> wrong_places(const std::string& place) {
  std::istringstream stream(place);
  std::array<double, 3> right{};
  for (double& number : right) stream >> number;
  std::vector<std::string> wrong;
  const auto add = [&](const std::array<double, 3>& numbers) {
    std::ostringstream text;
    text.precision(12);
    text << numbers[0] << ' ' << numbers[1] << ' ' << numbers[2];
    if (numbers != right) wrong.push_back(text.str());
  };
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> mirrored = right, exchanged = right;
    mirrored.at(k) = 0.0 - mirrored.at(k);
    std::swap(exchanged.at(k), exchanged.at((k + 1) % 3));
    add(mirrored);
    add(exchanged);
  }
  add({1e3 * right[0], 1e3 * right[1], 1e3 * right[2]});
  return wrong;
}

/// The closures after each of the corrections that a message lists.
inline std::vector<PlacedClosures> followed_apart(const PlacedClosures& closures,
                                                  const std::string& message) {
  std::vector<PlacedClosures> all;
  for (std::size_t start = 0; start < message.size();) {
    const std::size_t end = std::min(message.find(" or write", start + 1), message.size());
    all.push_back(followed(closures, message.substr(start, end - start)));
    start = end;
  }
  return all;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_URDF_DIAGNOSIS_PLACED_CLOSURES_H
