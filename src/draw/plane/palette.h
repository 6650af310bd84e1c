// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PLANE_PALETTE_H
#define PARALLEL_ASPECTS_DRAW_PLANE_PALETTE_H

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The colours of every picture of this package, which people with any colour vision can distinguish.
namespace parallel_aspects {

/// 0xRRGGBB.
using Rgb = std::uint32_t;

inline constexpr Rgb ink_color = 0x202020;
inline constexpr Rgb undecided_color = 0xBBBBBB;

/// How many colours each sign of det A has. The first six differ more than the others.
inline constexpr std::size_t hue_count = 24;

/// Light where det A > 0, dark where det A < 0; `hue` counts from 0 and comes again after `hue_count`.
Rgb aspect_color(int determinant_sign, std::size_t hue);

/// The colours of the aspects, by id - 1. Aspects differ from those of their working mode and of the
/// neighbouring modes, which differ in the sign of one B_jj, as long as no two neighbouring modes have more
/// than `hue_count` aspects of a sign of det A. More than the first six hues are taken where that needs them.
std::vector<Rgb> aspect_colors(const std::vector<Aspect>& aspects);

/// Of the skeletons of candidates, which differ from each other; they come again after `hue_count`.
Rgb candidate_color(std::size_t index);

/// Of actuated values with so many direct solutions, and of their poses: the more, the darker.
Rgb solutions_color(std::size_t solutions);

/// How one kind of boundary looks, and what it is called, in every picture.
struct BoundaryStyle {
  BoundaryKind kind;
  Rgb color;
  const char* name;                          ///< for programs
  const char* words;                         ///< for people
  const char* color_word;                    ///< "red"
  std::optional<ConstraintKind> constraint;  ///< that ends there; empty for singularities and actuated limits
};

/// One for each kind, in the order in which they are drawn, the last over the others.
const std::vector<BoundaryStyle>& boundary_styles();

const BoundaryStyle& style_of(BoundaryKind kind);
inline Rgb boundary_color(BoundaryKind kind) { return style_of(kind).color; }

/// Of the parallel index, 0 to 1: from red at a parallel singularity over yellow to blue at best.
Rgb index_color(double index);

/// Of the serial gates of a leg, in charts.
Rgb leg_color(std::size_t leg);

/// Of the sign of det A where aspects have no colours of their own; `pale` beside it.
Rgb sign_color(int determinant_sign, bool pale = false);

/// `share` of the way from one colour to the other.
Rgb mixed(Rgb one, Rgb other, double share);

/// `share` of the way to white, 0 to 1.
Rgb lightened(Rgb color, double share);

/// The colour at a share, 0 to 1, of the way through these.
Rgb color_along(const std::vector<Rgb>& stops, double share);

/// As "#rrggbb".
std::string color_text(Rgb color);

/// Black or white, whichever reads better on `background`.
Rgb readable_on(Rgb background);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PLANE_PALETTE_H
