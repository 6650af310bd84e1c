// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_VERDICTS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_VERDICTS_H

#include "aspects/constraints/constraint_tests.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// What is proved of the constraints of one box, in every working mode: each leg is tested once for each
/// branch and each pair of legs once for each pair of branches, when a mode first asks. Limits of actuated
/// joints and margins are not among them.
///
/// `Links` is where the links are on one kind of enclosures:
///  - points(j, sign): pointer to `LinkPoints`, null where they are not known;
///  - position() of the platform; turned(direction), of what is fixed in it.
template <std::size_t Legs, std::size_t D>
class ConstraintVerdicts {
 public:
  using Signs = std::array<int, Legs>;

  explicit ConstraintVerdicts(const ConstraintTests<D>& tests) : tests_(tests) {}

  /// From now on enclosures are tighter: what is unknown is tested again.
  void expect_tighter() noexcept { ++stage_; }

  template <class Links>
  Verdict all(const Signs& signs, const Links& links) {
    Verdict result = Verdict::holds;
    for (const ConstraintKind kind :
         {ConstraintKind::workspace, ConstraintKind::passive_limits, ConstraintKind::cones,
          ConstraintKind::obstacles, ConstraintKind::self_collision}) {
      result = both(result, of(kind, signs, links));
      if (result == Verdict::fails) break;
    }
    return result;
  }

  template <class Links>
  Verdict of(ConstraintKind kind, const Signs& signs, const Links& links) {
    switch (kind) {
      case ConstraintKind::workspace:
        return settle(workspace_, [&] { return tests_.workspace(links.position()); });
      case ConstraintKind::passive_limits:
        return both(hinge_limits(links),
                    of_all_legs([&](std::size_t j) { return passive_limits(j, signs[j], links); }));
      case ConstraintKind::cones:
        return of_all_legs([&](std::size_t j) { return cones(j, signs[j], links); });
      case ConstraintKind::obstacles:
        return both(platform(links),
                    of_all_legs([&](std::size_t j) { return obstacles(j, signs[j], links); }));
      case ConstraintKind::self_collision:
        return of_all_legs([&](std::size_t j) { return collisions(j, signs, links); });
      case ConstraintKind::actuated_limits:
      case ConstraintKind::margins:
        break;
    }
    return Verdict::holds;
  }

  /// Of the passive chain that holds the platform.
  template <class Links>
  Verdict hinge_limits(const Links& links) {
    if (!tests_.has_hinge_limits()) return Verdict::holds;
    return settle(hinge_limits_, [&] { return tests_.hinge_limits(links); });
  }

  /// Of one leg.
  template <class Links>
  Verdict passive_limits(std::size_t j, int sign, const Links& links) {
    if (!tests_.has_passive_limits(j)) return Verdict::holds;
    return settle(passive_limits_[j][branch(sign)], [&] {
      const auto* points = links.points(j, sign);
      return points != nullptr ? tests_.passive_limits(j, *points, links) : Verdict::unknown;
    });
  }

  /// Of one leg.
  template <class Links>
  Verdict cones(std::size_t j, int sign, const Links& links) {
    if (!tests_.has_cones(j)) return Verdict::holds;
    return settle(cones_[j][branch(sign)], [&] {
      const auto* points = links.points(j, sign);
      return points != nullptr ? tests_.cones(j, *points, links) : Verdict::unknown;
    });
  }

 private:
  struct Entry {
    Verdict verdict = Verdict::unknown;
    std::uint8_t stage = 0;  // of the enclosures that were tested last
  };

  static std::size_t branch(int sign) noexcept { return sign > 0 ? 1 : 0; }

  template <class Test>
  Verdict settle(Entry& entry, const Test& test) const {
    if (entry.verdict == Verdict::unknown && entry.stage < stage_) entry = {test(), stage_};
    return entry.verdict;
  }

  template <class Test>
  static Verdict of_all_legs(const Test& test) {
    Verdict result = Verdict::holds;
    for (std::size_t j = 0; j < Legs && result != Verdict::fails; ++j) result = both(result, test(j));
    return result;
  }

  template <class Links>
  Verdict platform(const Links& links) {
    if (!tests_.has_platform()) return Verdict::holds;
    return settle(platform_, [&] { return tests_.platform(links.anchors()); });
  }

  template <class Links>
  Verdict obstacles(std::size_t j, int sign, const Links& links) {
    if (!tests_.has_obstacles()) return Verdict::holds;
    return settle(obstacles_[j][branch(sign)], [&] {
      const auto* points = links.points(j, sign);
      return points != nullptr ? tests_.obstacles(j, *points) : Verdict::unknown;
    });
  }

  /// With the legs after leg j.
  template <class Links>
  Verdict collisions(std::size_t j, const Signs& signs, const Links& links) {
    Verdict result = Verdict::holds;
    for (std::size_t k = j + 1; k < Legs && result != Verdict::fails; ++k) {
      if (!tests_.can_collide(j, k)) continue;
      Entry& entry = collisions_[j][k][2 * branch(signs[j]) + branch(signs[k])];
      result = both(result, settle(entry, [&] {
                      const auto *one = links.points(j, signs[j]), *other = links.points(k, signs[k]);
                      if (one == nullptr || other == nullptr) return Verdict::unknown;
                      return tests_.collision(j, *one, k, *other);
                    }));
    }
    return result;
  }

  const ConstraintTests<D>& tests_;
  std::uint8_t stage_ = 1;
  Entry workspace_, platform_, hinge_limits_;
  std::array<std::array<Entry, 2>, Legs> passive_limits_, cones_, obstacles_;
  std::array<std::array<std::array<Entry, 4>, Legs>, Legs> collisions_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_VERDICTS_H
