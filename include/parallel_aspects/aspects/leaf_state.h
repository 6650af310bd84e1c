// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_LEAF_STATE_H
#define PARALLEL_ASPECTS_ASPECTS_LEAF_STATE_H

#include <cstdint>

namespace parallel_aspects {

/// What is proved of a pose box in one working mode s, with S(s, sigma) the singularity-free poses of that
/// mode where det A has the sign sigma:
///  - outside: it meets neither S(s,+) nor S(s,-);
///  - inside: it is a subset of S(s, sigma);
///  - undecided: neither, though S(s, sigma) may be ruled out for one sigma.
class LeafState {
 public:
  static constexpr LeafState outside() noexcept { return LeafState(0); }
  static constexpr LeafState inside(int sign) noexcept { return LeafState(bit(sign) | proved); }
  static constexpr LeafState undecided(bool may_be_positive, bool may_be_negative) noexcept {
    return LeafState(static_cast<std::uint8_t>((may_be_positive ? 1U : 0U) | (may_be_negative ? 2U : 0U)));
  }

  /// Inner nodes: this mode is told by the children.
  static constexpr LeafState divided() noexcept { return LeafState(0x10); }
  /// Told by an ancestor.
  static constexpr LeafState inherited() noexcept { return LeafState(0x20); }
  /// Not classified yet.
  static constexpr LeafState pending() noexcept { return LeafState(0x40); }

  constexpr LeafState() noexcept = default;

  constexpr bool is_inside() const noexcept { return (code_ & proved) != 0; }
  constexpr bool is_inside(int sign) const noexcept { return code_ == (bit(sign) | proved); }
  constexpr bool is_undecided() const noexcept { return code_ >= 1 && code_ <= 3; }
  constexpr bool may_be(int sign) const noexcept { return code_ < 8 && (code_ & bit(sign)) != 0; }
  constexpr bool is_leaf() const noexcept { return code_ < 8; }
  constexpr bool is_divided() const noexcept { return code_ == 0x10; }
  constexpr bool is_pending() const noexcept { return code_ == 0x40; }

  friend constexpr bool operator==(LeafState a, LeafState b) noexcept { return a.code_ == b.code_; }

 private:
  static constexpr std::uint8_t proved = 4;
  static constexpr std::uint8_t bit(int sign) noexcept { return sign > 0 ? 1 : 2; }
  explicit constexpr LeafState(unsigned code) noexcept : code_(static_cast<std::uint8_t>(code)) {}

  std::uint8_t code_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_LEAF_STATE_H
