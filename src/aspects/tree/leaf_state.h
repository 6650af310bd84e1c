// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_LEAF_STATE_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_LEAF_STATE_H

#include <cstdint>
#include <optional>

namespace parallel_aspects {

/// What is proved of a pose box in one working mode s, with S(s, sigma) the singularity-free poses of that
/// mode where det A has the sign sigma:
///  - outside: it meets neither S(s,+) nor S(s,-);
///  - inside: it is a subset of S(s, sigma);
///  - undecided: neither, though S(s, sigma) may be ruled out for one sigma.
/// The part of S(s, sigma) in an undecided box is *whole* where all of it is proved to lie in one aspect.
class LeafState {
 public:
  static constexpr LeafState outside() noexcept { return LeafState(0); }
  static constexpr LeafState inside(int sign) noexcept { return LeafState(bit(sign) | proved); }
  static constexpr LeafState undecided(bool may_be_positive, bool may_be_negative) noexcept {
    return LeafState((may_be_positive ? 1U : 0U) | (may_be_negative ? 2U : 0U));
  }

  /// Inner nodes: the children hold this mode's state.
  static constexpr LeafState divided() noexcept { return LeafState(inner | 1U); }
  /// Told by an ancestor.
  static constexpr LeafState inherited() noexcept { return LeafState(inner | 2U); }
  /// Not classified yet.
  static constexpr LeafState pending() noexcept { return LeafState(inner | 4U); }

  constexpr LeafState() noexcept = default;

  /// The state as a number, to keep in a file.
  constexpr std::uint8_t code() const noexcept { return code_; }
  /// The divided, outside, inside or undecided state with this `code()`; nothing where there is none.
  static constexpr std::optional<LeafState> from_code(std::uint8_t code) noexcept {
    const LeafState state(code);
    const bool is_known = code == outside().code_ || code == inside(1).code_ || code == inside(-1).code_ ||
                          state.is_divided() || state.is_undecided();
    return is_known ? std::optional<LeafState>(state) : std::nullopt;
  }

  constexpr bool is_inside() const noexcept { return (code_ & (inner | proved)) == proved; }
  constexpr bool is_inside(int sign) const noexcept { return is_inside() && (code_ & bit(sign)) != 0; }
  constexpr bool is_outside() const noexcept { return (code_ & (inner | signs)) == 0; }
  constexpr bool is_undecided() const noexcept {
    return (code_ & (inner | proved)) == 0 && (code_ & signs) != 0;
  }
  constexpr bool may_be(int sign) const noexcept { return (code_ & inner) == 0 && (code_ & bit(sign)) != 0; }
  constexpr bool is_leaf() const noexcept { return (code_ & inner) == 0; }
  constexpr bool is_divided() const noexcept { return code_ == (inner | 1U); }
  constexpr bool is_pending() const noexcept { return code_ == (inner | 4U); }

  /// Whether the box meets S(s, sign), if at all, in one aspect only.
  constexpr bool is_whole(int sign) const noexcept {
    return is_inside(sign) || (is_undecided() && (code_ & whole_bit(sign)) != 0);
  }

  /// The sign of det A that is proved at the center of an undecided box; 0 where none is.
  constexpr int center_sign() const noexcept {
    if ((code_ & center_positive) != 0) return 1;
    return (code_ & center_negative) != 0 ? -1 : 0;
  }

  /// The same undecided state with more proved.
  constexpr LeafState with_whole(int sign) const noexcept { return LeafState(code_ | whole_bit(sign)); }
  constexpr LeafState with_center(int sign) const noexcept {
    return LeafState(code_ | (sign > 0 ? center_positive : center_negative));
  }
  constexpr LeafState without(int sign) const noexcept {
    return (code_ & signs) == bit(sign) ? outside() : LeafState(code_ & ~bit(sign) & ~whole_bit(sign));
  }

  /// What is proved where S(s, +) and S(s, -) change places. Inner nodes stay as they are.
  constexpr LeafState with_signs_exchanged() const noexcept {
    if ((code_ & inner) != 0) return *this;
    const unsigned positive = bit(1) | whole_bit(1) | center_positive;
    return LeafState((code_ & proved) | (code_ & positive) << 1U | (code_ >> 1U & positive));
  }

  friend constexpr bool operator==(LeafState a, LeafState b) noexcept { return a.code_ == b.code_; }

 private:
  static constexpr unsigned signs = 1U | 2U, proved = 4U, center_positive = 32U, center_negative = 64U,
                            inner = 128U;
  static constexpr unsigned bit(int sign) noexcept { return sign > 0 ? 1U : 2U; }
  static constexpr unsigned whole_bit(int sign) noexcept { return sign > 0 ? 8U : 16U; }
  explicit constexpr LeafState(unsigned code) noexcept : code_(static_cast<std::uint8_t>(code)) {}

  std::uint8_t code_ = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_LEAF_STATE_H
