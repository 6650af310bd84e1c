// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/command_options.h"

#include "model/number_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int digits = 12;
constexpr double noise = 1e-12;

}  // namespace

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string("_-./=+:,@%").find(letter) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string option_name(const std::string& key) {
  static const std::array<std::pair<std::string, std::string>, 4> options{
      {{"base_link", "--base"},
       {"operational_point", "--platform"},
       {"actuated_joints", "--actuated"},
       {"closures", "--closures"}}};
  for (const auto& [known, option] : options)
    if (known == key) return option;
  return key;
}

std::string option_for(const std::string& key, const std::vector<std::string>& values) {
  const std::string option = option_name(key);
  if (option == key) return key;
  std::string joined;
  for (const std::string& value : values) joined += (joined.empty() ? "" : " ") + value;
  return option + " " + shell_word(joined);
}

std::string coordinate_text(double value) {
  return number_text(std::abs(value) < noise ? 0.0 : value, digits);
}

std::string placed_name(const std::string& link, const Eigen::Vector3d& xyz) {
  return link + "@" + coordinate_text(xyz.x()) + ":" + coordinate_text(xyz.y()) + ":" +
         coordinate_text(xyz.z());
}

}  // namespace parallel_aspects
