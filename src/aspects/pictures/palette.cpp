// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/pictures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace parallel_aspects {
namespace {

// Chosen so that any two of a tone stay apart for protanopes and deuteranopes as well (a test computes it);
// most are of Paul Tol's schemes.
constexpr std::array<Rgb, hue_count> light_hues{0x77AADD, 0xEEDD88, 0xEE8866, 0x44BB99, 0xFFCCDD, 0xBBCC33};
constexpr std::array<Rgb, hue_count> dark_hues{0x332288, 0x117733, 0xAA4499, 0x663333, 0x5B5BC0, 0x8C510A};

// What it costs to share a hue: more within a mode than beside it, and a little with any other aspect.
constexpr int in_mode = 1000, beside_mode = 30, elsewhere = 1;

int cost_of_sharing(const Aspect& one, const Aspect& other) {
  std::size_t different = 0;
  for (std::size_t leg = 0; leg < one.mode.leg_count(); ++leg)
    if (one.mode.sign(leg) != other.mode.sign(leg)) ++different;
  return different == 0 ? in_mode : different == 1 ? beside_mode : elsewhere;
}

std::uint32_t channel(Rgb color, unsigned shift) { return color >> shift & 0xFFU; }

}  // namespace

Rgb aspect_color(int determinant_sign, std::size_t hue) {
  return (determinant_sign > 0 ? light_hues : dark_hues)[hue % hue_count];
}

std::vector<Rgb> aspect_colors(const std::vector<Aspect>& aspects) {
  std::vector<std::size_t> hues;
  std::vector<Rgb> colors;
  for (const Aspect& aspect : aspects) {
    std::array<int, hue_count> costs{};
    for (std::size_t i = 0; i < hues.size(); ++i)
      if (aspects[i].determinant_sign == aspect.determinant_sign)
        costs[hues[i]] += cost_of_sharing(aspect, aspects[i]);
    hues.push_back(static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin()));
    colors.push_back(aspect_color(aspect.determinant_sign, hues.back()));
  }
  return colors;
}

// After Paul Tol's iridescent scheme, by rising numbers, which are even but where poses are singular.
Rgb solutions_color(std::size_t solutions) {
  constexpr std::array<Rgb, 4> colors{0xFEFBE9, 0xD5ECC8, 0x8DCBE4, 0x6A6FB5};
  return colors[std::min((solutions + 1) / 2, colors.size() - 1)];
}

Rgb boundary_color(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::parallel:
      return 0xB00020;
    case BoundaryKind::serial:
      return 0x00305A;
    case BoundaryKind::passive_limit:
      return 0xA0826D;
    case BoundaryKind::cone:
      return 0xC71585;
    case BoundaryKind::self_collision:
      return 0x8A2BE2;
    case BoundaryKind::obstacle:
      return 0xE07B00;
    case BoundaryKind::workspace:
      return 0x2E8B57;
    case BoundaryKind::margin:
      return 0xD9A400;
    case BoundaryKind::limit:
      break;
  }
  return 0x707070;
}

const std::vector<std::pair<BoundaryKind, const char*>>& boundary_words() {
  static const std::vector<std::pair<BoundaryKind, const char*>> words{
      {BoundaryKind::limit, "joint limit"},
      {BoundaryKind::passive_limit, "limit of a passive joint"},
      {BoundaryKind::cone, "cone of a ball joint"},
      {BoundaryKind::self_collision, "links touch"},
      {BoundaryKind::obstacle, "obstacle"},
      {BoundaryKind::workspace, "workspace"},
      {BoundaryKind::margin, "margin from singularities"},
      {BoundaryKind::serial, "serial singularity, Bjj = 0"},
      {BoundaryKind::parallel, "parallel singularity, det A = 0"}};
  return words;
}

Rgb lightened(Rgb color, double share) {
  Rgb result = 0;
  for (const unsigned shift : {16U, 8U, 0U}) {
    const double from = channel(color, shift);
    result |= static_cast<Rgb>(std::lround(from + share * (255.0 - from))) << shift;
  }
  return result;
}

std::string color_text(Rgb color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", color & 0xFFFFFFU);
  return text;
}

Rgb readable_on(Rgb background) {
  const double luminance =
      0.299 * channel(background, 16) + 0.587 * channel(background, 8) + 0.114 * channel(background, 0);
  return luminance > 127.5 ? 0x000000 : 0xFFFFFF;
}

}  // namespace parallel_aspects
