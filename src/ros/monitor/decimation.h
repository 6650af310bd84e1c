// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_DECIMATION_H
#define PARALLEL_ASPECTS_ROS_MONITOR_DECIMATION_H

#include <parallel_aspects/AspectState.h>

#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Lets every n-th message through, the first of all included, and tells which ones say something new.
class Decimation {
 public:
  /// `every`: 1 or more.
  explicit Decimation(int every) : every_(static_cast<unsigned>(every)) {}

  bool next() noexcept {
    const bool through = count_ == 0;
    count_ = (count_ + 1) % every_;
    return through;
  }

  /// Whether status, level, working mode, sign of det A or aspect differ from those of the call before.
  bool differs(const AspectState& state) {
    if (state.status.code == code_ && state.level == level_ && state.aspect == aspect_ &&
        state.determinant_sign == sign_ && state.working_mode == working_mode_)
      return false;
    code_ = state.status.code;
    level_ = state.level;
    aspect_ = state.aspect;
    sign_ = state.determinant_sign;
    working_mode_ = state.working_mode;
    return true;
  }

 private:
  const unsigned every_;
  unsigned count_ = 0;
  std::uint8_t code_ = 0, level_ = 0;
  std::uint32_t aspect_ = 0;
  std::int8_t sign_ = 0;
  std::vector<std::int8_t> working_mode_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_DECIMATION_H
