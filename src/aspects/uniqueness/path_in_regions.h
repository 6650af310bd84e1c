// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PATH_IN_REGIONS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PATH_IN_REGIONS_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/solutions/actuated_space.h"
#include "interval/interval.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace parallel_aspects {

/// Poses from one to another, as `pose_between` has them, of a robot of SE2 with three struts.
class StrutSegment {
 public:
  /// The manipulator must outlive it.
  StrutSegment(const Manipulator& manipulator, const StrutSlice& family, const Pose& from,
               const Pose& to) noexcept;

  Pose at(double t) const noexcept { return pose_between(from_, to_, t); }

  /// Lengths of the struts for all t, from 0 to 1, in a range [m], and their derivatives by t. Nothing where
  /// a length may be 0. Needs a live `RoundingUpward`.
  struct Enclosure {
    LengthRanges lengths, rates;
  };
  std::optional<Enclosure> over(const Interval& t) const noexcept;

 private:
  const Manipulator& manipulator_;
  std::array<std::size_t, 3> legs_;
  Pose from_, to_;
};

/// Proves of a path that it is in basic regions, and in strips between these that it crosses once.
///
/// Over a box of lengths in one piece a path stays at one solution, since none is singular there: it is in
/// one region. So it is over a box in two pieces where its ends lie in either, in one region: over the part
/// of a piece in the box, which is convex, it is at the solution that it has there at its end. A box in one
/// cell with a strip may be crossed where  slope . lengths  is strictly monotone: before the strip the path
/// is in one piece, behind it in the other, and in it no two poses have the same lengths; nor has any pose of
/// a region lengths in a strip.
class PathInRegions {
 public:
  using Locate = std::function<std::optional<std::size_t>(const Pose&)>;

  /// What it is given must outlive it. `locate` returns the region of a pose.
  PathInRegions(const ActuatedSpace& space, const Locate& locate) noexcept : space_(space), locate_(locate) {}

  /// The next segment; false where that is not proved. Needs a live `RoundingUpward`.
  bool add(const StrutSegment& segment);

  const std::set<std::size_t>& regions() const noexcept { return regions_; }

  /// Whether no two strips that were crossed may have lengths in common.
  bool crosses_apart() const noexcept;

 private:
  /// A time, and what is known there.
  struct Stop {
    double t = 0.0;
    std::optional<std::size_t> region;
    std::optional<PieceIndex> piece;
  };

  Stop stop(const StrutSegment& segment, double t) const;
  bool prove(const StrutSegment& segment, const Stop& from, const Stop& to, int depth);
  bool is_proved(const StrutSegment::Enclosure& over, const Stop& from, const Stop& to);
  std::optional<Stop> between(const StrutSegment& segment, const Stop& from, const Stop& to) const;

  const ActuatedSpace& space_;
  const Locate& locate_;
  std::set<std::size_t> regions_;
  std::vector<LengthRanges> crossings_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_PATH_IN_REGIONS_H
