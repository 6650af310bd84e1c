// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/working_mode.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

bool allowed(const Manipulator& manipulator, const WorkingMode& mode) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (!manipulator.leg(j).has_branch(mode.sign(j))) return false;
  return true;
}

}  // namespace

WorkingMode WorkingMode::from_index(std::size_t leg_count, std::size_t index) noexcept {
  WorkingMode mode(leg_count);
  mode.negative_ = static_cast<std::uint8_t>(index);
  return mode;
}

std::optional<WorkingMode> WorkingMode::from_signs(const std::vector<int>& signs) {
  const bool all_signs = std::all_of(signs.begin(), signs.end(), [](int s) { return s == 1 || s == -1; });
  if (!all_signs || signs.empty() || signs.size() > static_cast<std::size_t>(max_legs)) return std::nullopt;
  WorkingMode mode(signs.size());
  for (std::size_t j = 0; j < signs.size(); ++j) mode.set_sign(j, signs[j]);
  return mode;
}

void WorkingMode::set_sign(std::size_t leg, int sign) noexcept {
  const auto bit = static_cast<std::uint8_t>(1U << leg);
  negative_ = static_cast<std::uint8_t>(sign < 0 ? negative_ | bit : negative_ & ~bit);
}

std::vector<int> WorkingMode::signs() const {
  std::vector<int> result(leg_count());
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = sign(j);
  return result;
}

std::string to_string(const WorkingMode& mode) {
  std::string text = "(";
  for (std::size_t j = 0; j < mode.leg_count(); ++j) {
    text += j == 0 ? "" : ",";
    text += mode.sign(j) > 0 ? '+' : '-';
  }
  return text + ")";
}

std::vector<WorkingMode> working_modes(const Manipulator& manipulator) {
  std::vector<WorkingMode> modes;
  for (std::size_t index = 0; index < std::size_t{1} << manipulator.leg_count(); ++index) {
    const WorkingMode mode = WorkingMode::from_index(manipulator.leg_count(), index);
    if (allowed(manipulator, mode)) modes.push_back(mode);
  }
  return modes;
}

}  // namespace parallel_aspects
