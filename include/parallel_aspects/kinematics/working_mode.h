// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_WORKING_MODE_H
#define PARALLEL_ASPECTS_KINEMATICS_WORKING_MODE_H

#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Mf_i of the paper: the vector of signs of B_jj, one a leg, none zero.
class WorkingMode {
 public:
  WorkingMode() = default;  ///< of no leg

  /// All signs positive. `leg_count` at most `max_legs`.
  explicit WorkingMode(std::size_t leg_count) noexcept : legs_(static_cast<std::uint8_t>(leg_count)) {}

  /// The mode whose `index()` this is; `index` below 2^leg_count.
  static WorkingMode from_index(std::size_t leg_count, std::size_t index) noexcept;

  /// From signs as people write them, each 1 or -1; nothing when one is neither or there are none or too
  /// many.
  static std::optional<WorkingMode> from_signs(const std::vector<int>& signs);

  /// How many signs there are, 0 to `max_legs`.
  std::size_t leg_count() const noexcept { return legs_; }

  /// Bit j is set where the sign of leg j is negative; so 0 is (+, ..., +).
  std::size_t index() const noexcept { return negative_; }

  /// +1 or -1.
  int sign(std::size_t leg) const noexcept { return (negative_ >> leg & 1U) != 0 ? -1 : 1; }

  /// `leg` below `leg_count()`, `sign` 1 or -1.
  void set_sign(std::size_t leg, int sign) noexcept;

  /// The signs, each 1 or -1, in the order of the legs.
  std::vector<int> signs() const;

  /// Whether both have the same signs of the same number of legs.
  friend bool operator==(const WorkingMode& a, const WorkingMode& b) noexcept {
    return a.legs_ == b.legs_ && a.negative_ == b.negative_;
  }

  /// Whether they differ.
  friend bool operator!=(const WorkingMode& a, const WorkingMode& b) noexcept { return !(a == b); }

 private:
  std::uint8_t legs_ = 0;
  std::uint8_t negative_ = 0;
};

/// "(+,-)".
std::string to_string(const WorkingMode& mode);

/// Every working mode that the kinds of the legs allow, by rising index. Joint limits are not considered.
std::vector<WorkingMode> working_modes(const Manipulator& manipulator);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_WORKING_MODE_H
