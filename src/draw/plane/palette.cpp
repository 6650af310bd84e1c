// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/palette.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace parallel_aspects {
namespace {

// Chosen so that any two of a tone stay apart for protanopes and deuteranopes as well (a test computes it).
// Most of the first six are of Paul Tol's schemes; each of the others is as far as can be from all before it,
// and from boundaries.
constexpr std::array<Rgb, hue_count> light_hues{0x77AADD, 0xEEDD88, 0xEE8866, 0x44BB99, 0xFFCCDD, 0xBBCC33,
                                                0x9988FF, 0xDDEEBB, 0xCCFF11, 0x55AA00, 0xEECCFF, 0x77CC88,
                                                0xFFEE66, 0x66AABB, 0xAACC55, 0x99AAFF, 0xBBDDBB, 0x55AA55,
                                                0x55CCDD, 0x88EE00, 0xFFDD77, 0x33AA99, 0x999977, 0x9988DD};
constexpr std::array<Rgb, hue_count> dark_hues{0x332288, 0x117733, 0xAA4499, 0x663333, 0x5B5BC0, 0x8C510A,
                                               0x0000FF, 0x4433CC, 0x005566, 0x000099, 0x112200, 0x111155,
                                               0x334400, 0x0044FF, 0x0000CC, 0x662244, 0x557755, 0x663388,
                                               0x6655DD, 0x331133, 0x993377, 0x2233AA, 0x000077, 0x113300};
constexpr std::size_t first_hues = 6;

// The cost of sharing a hue: more within a mode than beside it, and a little with any other aspect; and of
// taking one that is not among the first.
constexpr int in_mode = 10000, beside_mode = 200, elsewhere = 1, further = 50;

std::size_t different_signs(const WorkingMode& one, const WorkingMode& other) {
  std::size_t different = 0;
  for (std::size_t leg = 0; leg < one.leg_count(); ++leg)
    if (one.sign(leg) != other.sign(leg)) ++different;
  return different;
}

int cost_of_sharing(const Aspect& one, const Aspect& other) {
  const std::size_t different = different_signs(one.mode, other.mode);
  return different == 0 ? in_mode : different == 1 ? beside_mode : elsewhere;
}

// Shares the hues evenly, and none of the first six more than needed.
std::vector<std::size_t> even_hues(const std::vector<Aspect>& aspects) {
  std::vector<std::size_t> hues;
  for (const Aspect& aspect : aspects) {
    std::array<int, hue_count> costs{};
    std::fill(costs.begin() + first_hues, costs.end(), further);
    for (std::size_t i = 0; i < hues.size(); ++i)
      if (aspects[i].determinant_sign == aspect.determinant_sign)
        costs[hues[i]] += cost_of_sharing(aspect, aspects[i]);
    hues.push_back(static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin()));
  }
  return hues;
}

// Neighbours of a mode with an even number of negative signs all have an odd number: those take the last
// hues.
std::vector<std::size_t> hues_from_both_ends(const std::vector<Aspect>& aspects) {
  std::vector<std::size_t> hues;
  for (std::size_t i = 0; i < aspects.size(); ++i) {
    const WorkingMode& mode = aspects[i].mode;
    std::size_t place = 0, negative = 0;
    for (std::size_t k = 0; k < i; ++k)
      if (aspects[k].determinant_sign == aspects[i].determinant_sign && aspects[k].mode == mode) ++place;
    for (std::size_t leg = 0; leg < mode.leg_count(); ++leg) negative += mode.sign(leg) < 0 ? 1U : 0U;
    place %= hue_count;
    hues.push_back(negative % 2 == 0 ? place : hue_count - 1 - place);
  }
  return hues;
}

bool neighbours_share(const std::vector<Aspect>& aspects, const std::vector<std::size_t>& hues) {
  for (std::size_t i = 0; i < hues.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (hues[i] == hues[k] && aspects[i].determinant_sign == aspects[k].determinant_sign &&
          different_signs(aspects[i].mode, aspects[k].mode) <= 1)
        return true;
  return false;
}

std::uint32_t channel(Rgb color, unsigned shift) { return color >> shift & 0xFFU; }

}  // namespace

Rgb aspect_color(int determinant_sign, std::size_t hue) {
  return (determinant_sign > 0 ? light_hues : dark_hues)[hue % hue_count];
}

std::vector<Rgb> aspect_colors(const std::vector<Aspect>& aspects) {
  std::vector<std::size_t> hues = even_hues(aspects);
  if (neighbours_share(aspects, hues)) hues = hues_from_both_ends(aspects);
  std::vector<Rgb> colors;
  for (std::size_t i = 0; i < aspects.size(); ++i)
    colors.push_back(aspect_color(aspects[i].determinant_sign, hues[i]));
  return colors;
}

Rgb candidate_color(std::size_t index) { return aspect_color(-1, index); }

// After Paul Tol's iridescent scheme, by rising numbers, which are even but where poses are singular.
Rgb solutions_color(std::size_t solutions) {
  constexpr std::array<Rgb, 4> colors{0xFEFBE9, 0xD5ECC8, 0x8DCBE4, 0x6A6FB5};
  return colors[std::min((solutions + 1) / 2, colors.size() - 1)];
}

const std::vector<BoundaryStyle>& boundary_styles() {
  using Kind = BoundaryKind;
  using Constraint = ConstraintKind;
  static const std::vector<BoundaryStyle> styles{
      {Kind::limit, 0x707070, "limit", "joint limit", "grey", {}},
      {Kind::passive_limit, 0xA0826D, "passive_limit", "limit of a passive joint", "brown",
       Constraint::passive_limits},
      {Kind::cone, 0xC71585, "cone", "cone of a ball joint", "pink", Constraint::cones},
      {Kind::self_collision, 0x8A2BE2, "self_collision", "links touch", "violet", Constraint::self_collision},
      {Kind::obstacle, 0xE07B00, "obstacle", "obstacle", "orange", Constraint::obstacles},
      {Kind::workspace, 0x2E8B57, "workspace", "workspace", "green", Constraint::workspace},
      {Kind::margin, 0xD9A400, "margin", "margin from singularities", "yellow", Constraint::margins},
      {Kind::serial, 0x00305A, "serial", "serial singularity, Bjj = 0", "blue", {}},
      {Kind::parallel, 0xB00020, "parallel", "parallel singularity, det A = 0", "red", {}}};
  return styles;
}

const BoundaryStyle& style_of(BoundaryKind kind) {
  const auto found = std::find_if(boundary_styles().begin(), boundary_styles().end(),
                                  [kind](const BoundaryStyle& style) { return style.kind == kind; });
  assert(found != boundary_styles().end());  // a kind without a row
  return *found;
}

// Three colours that people with any colour vision can distinguish (after Paul Tol's "high contrast" scheme).
Rgb index_color(double index) { return color_along({0xBB5566, 0xDDAA33, 0x004488}, index); }

// After Paul Tol's colour schemes for people with any colour vision.
Rgb leg_color(std::size_t leg) {
  constexpr std::array<Rgb, 6> colors{0x228833, 0xAA3377, 0xCCBB44, 0x66CCEE, 0xEE7733, 0x332288};
  return colors[leg % colors.size()];
}

Rgb sign_color(int determinant_sign, bool pale) {
  if (determinant_sign > 0) return pale ? 0xB4C8DD : 0x4477AA;
  return pale ? 0xEBC2C9 : 0xCC6677;
}

Rgb mixed(Rgb one, Rgb other, double share) {
  Rgb result = 0;
  for (const unsigned shift : {16U, 8U, 0U}) {
    const double from = channel(one, shift), to = channel(other, shift);
    result |= static_cast<Rgb>(std::lround(from + share * (to - from))) << shift;
  }
  return result;
}

Rgb lightened(Rgb color, double share) { return mixed(color, 0xFFFFFF, share); }

Rgb color_along(const std::vector<Rgb>& stops, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[below], stops[below + 1], place - static_cast<double>(below));
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
