// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ZEROS_KRAWCZYK_H
#define PARALLEL_ASPECTS_ASPECTS_ZEROS_KRAWCZYK_H

#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// N functions of N coordinates over a box: their values in the middle, and their derivatives everywhere in
/// the box, by radians where a coordinate is an angle.
template <std::size_t N>
struct SystemOverBox {
  std::array<Interval, N> center;
  std::array<std::array<Interval, N>, N> jacobian;
  /// Where the functions depend on a parameter from -1 to 1: this times it is taken from all.
  std::array<Interval, N> drift{};
};

/// Two functions of the coordinates of a slice.
using PairOverBox = SystemOverBox<2>;

/// What Krawczyk's test proves of the zeros of all functions in a box.
enum class Zeros {
  none,     ///< there are none
  one,      ///< there is exactly one, and it is regular
  unknown,  ///< nothing is proved
};

struct ZeroSearch {
  Zeros zeros = Zeros::unknown;
  Box enclosure;  ///< of every zero in the box [half turns]
};

/// How far the faces of a box are from its middle, along one coordinate [rad].
struct DistanceToFaces {
  double least, most;
};

/// What is proved of the zeros of a system in a box.
template <std::size_t N>
struct SystemZeros {
  Zeros zeros = Zeros::unknown;
  /// Encloses them, from the middle of the box [rad]. Nothing where there are none, or arithmetic fails.
  std::optional<std::array<Interval, N>> from_middle;
};

/// Krawczyk's test (R. Krawczyk, Computing 4, 1969): with x in the middle of the box X, F there and F' over
/// X, every zero in X is in K = x - Y F(x) + (I - Y F') (X - x), whatever Y; and if K lies in the interior of
/// X, F has exactly one zero in X. With a drift all of this holds for each value of the parameter. For two
/// and for four functions. Needs a live `RoundingUpward`.
template <std::size_t N>
SystemZeros<N> krawczyk_test(const std::array<DistanceToFaces, N>& faces,
                             const SystemOverBox<N>& system) noexcept;

/// How far the faces of a box of a slice are from its middle, along coordinate i.
DistanceToFaces distance_to_faces(const Box& box, std::size_t i) noexcept;

/// Coordinate i of `box`, whose edges are in half turns, is set to this much [rad] from its middle.
void set_from_middle(const Interval& radians, std::size_t i, Box& box) noexcept;

/// The test of a box of a slice.
ZeroSearch krawczyk_test(const Box& box, const PairOverBox& pair) noexcept;

/// What two boxes that hold one point have in common.
Box intersection(const Box& a, const Box& b) noexcept;

/// The smallest box that holds both.
Box hull_of(const Box& a, const Box& b) noexcept;

/// `box`, about its middle, with edges this many times as long.
Box scaled(const Box& box, double factor) noexcept;

/// Whether the second lies in the first.
bool contains(const Box& outer, const Box& inner) noexcept;

/// `box`, whose angles are its first two coordinates, moved by whole turns so that these are from -1 to 1 in
/// its middle. Here and below ends are moved outward by what the sums are rounded by.
Box without_turns(Box box) noexcept;

/// `box`, its angles moved by whole turns to where those of a point are.
Box beside(const MapPoint& at, Box box) noexcept;

/// Whether `inner`, moved by some whole turns, lies in `outer`.
bool contains_up_to_turns(const Box& outer, const Box& inner) noexcept;

/// Whether both, one of them moved by some whole turns, may have a point in common.
bool meet_up_to_turns(const Box& a, const Box& b) noexcept;

/// A zero of two functions over a slice, or, where these depend on parameters, one for each value of them.
struct KnownZero {
  Box unique;     ///< holds this zero and no other [half turns]
  Box enclosure;  ///< of it
};

/// Zeros that are proved, no two of them the same.
class KnownZeros {
 public:
  const std::vector<KnownZero>& all() const noexcept { return zeros_; }

  /// Whether a box that holds one known zero and no other holds all of this one.
  bool cover(const Box& box) const noexcept;

  /// Adds the zero, if it is new. False where it is not proved that it is, nor that it is known.
  bool note(const KnownZero& found);

 private:
  std::vector<KnownZero> zeros_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ZEROS_KRAWCZYK_H
