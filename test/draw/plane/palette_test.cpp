// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/palette.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Linear RGB seen by people who lack a kind of cone: Machado, Oliveira and Fernandes, 2009, at full severity.
const Matrix3d& normal_vision() {
  static const Matrix3d matrix = Matrix3d::Identity();
  return matrix;
}
const Matrix3d& protanopia() {
  static const Matrix3d matrix = (Matrix3d() << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216,
                                  -0.003882, -0.048116, 1.051998)
                                     .finished();
  return matrix;
}
const Matrix3d& deuteranopia() {
  static const Matrix3d matrix = (Matrix3d() << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413,
                                  -0.011820, 0.042940, 0.968881)
                                     .finished();
  return matrix;
}

double linear(unsigned channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// CIE L*a*b* under D65.
Vector3d lab(Rgb color, const Matrix3d& vision) {
  const Vector3d seen =
      (vision * Vector3d(linear(color >> 16U & 255U), linear(color >> 8U & 255U), linear(color & 255U)))
          .cwiseMax(0.0)
          .cwiseMin(1.0);
  const Vector3d xyz((0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.9505,
                     0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2],
                     (0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.089);
  const Vector3d f =
      xyz.unaryExpr([](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; });
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

// A difference of 2.3 is just seen.
TEST(Palette, HuesOfAToneAreApartForEveryVision) {
  for (const Matrix3d& vision : {normal_vision(), protanopia(), deuteranopia()})
    for (const int sign : {1, -1})
      for (std::size_t a = 0; a < hue_count; ++a)
        for (std::size_t b = 0; b < a; ++b)
          EXPECT_GT((lab(aspect_color(sign, a), vision) - lab(aspect_color(sign, b), vision)).norm(),
                    a < 6 ? 11.0 : 9.5)
              << std::hex << aspect_color(sign, a) << ' ' << aspect_color(sign, b);
}

TEST(Palette, TheToneShowsTheSignOfDetA) {
  for (const Matrix3d& vision : {normal_vision(), protanopia(), deuteranopia()})
    for (std::size_t hue = 0; hue < hue_count; ++hue) {
      EXPECT_GT(lab(aspect_color(1, hue), vision)[0], 60.0);
      EXPECT_LT(lab(aspect_color(-1, hue), vision)[0], 50.0);
    }
  EXPECT_EQ(readable_on(aspect_color(1, 0)), 0x000000U);
  EXPECT_EQ(readable_on(aspect_color(-1, 0)), 0xFFFFFFU);
}

std::size_t different_signs(const WorkingMode& a, const WorkingMode& b) {
  std::size_t count = 0;
  for (std::size_t leg = 0; leg < a.leg_count(); ++leg) count += a.sign(leg) != b.sign(leg) ? 1 : 0;
  return count;
}

// Eight modes of three legs, with so many aspects of each sign.
std::vector<Aspect> aspects_of_eight_modes(std::size_t of_each_sign) {
  std::vector<Aspect> aspects;
  for (std::size_t mode = 0; mode < 8; ++mode)
    for (std::size_t i = 0; i < 2 * of_each_sign; ++i) {
      aspects.emplace_back();
      aspects.back().id = static_cast<int>(aspects.size());
      aspects.back().mode = WorkingMode::from_index(3, mode);
      aspects.back().determinant_sign = i % 2 == 0 ? 1 : -1;
    }
  return aspects;
}

TEST(Palette, AspectsDifferFromThoseOfTheirModeAndOfItsNeighbours) {
  for (const std::size_t of_each_sign : {1U, 2U, 4U, 8U, 12U}) {
    const std::vector<Aspect> aspects = aspects_of_eight_modes(of_each_sign);
    const std::vector<Rgb> colors = aspect_colors(aspects);
    ASSERT_EQ(colors.size(), aspects.size());
    for (std::size_t i = 0; i < aspects.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        if (different_signs(aspects[i].mode, aspects[k].mode) > 1) continue;
        EXPECT_NE(colors[i], colors[k]) << of_each_sign << ": " << i << ' ' << k;
      }
  }
}

// Two of each sign in eight modes need four.
TEST(Palette, FewAspectsHaveTheColoursThatDifferMost) {
  for (const std::size_t of_each_sign : {1U, 2U}) {
    std::set<Rgb> first;
    for (std::size_t hue = 0; hue < 6; ++hue)
      for (const int sign : {1, -1}) first.insert(aspect_color(sign, hue));
    for (const Rgb color : aspect_colors(aspects_of_eight_modes(of_each_sign)))
      EXPECT_EQ(first.count(color), 1U) << std::hex << color;
  }
}

TEST(Palette, HuesComeAgainWhereThereAreMoreAspects) {
  std::vector<Aspect> aspects(3 * hue_count);
  for (Aspect& aspect : aspects) {
    aspect.mode = WorkingMode::from_index(2, 1);
    aspect.determinant_sign = 1;
  }
  const std::vector<Rgb> colors = aspect_colors(aspects);
  for (std::size_t hue = 0; hue < hue_count; ++hue)
    EXPECT_EQ(std::count(colors.begin(), colors.end(), aspect_color(1, hue)), 3);
  EXPECT_EQ(std::set<Rgb>(colors.begin(), colors.begin() + hue_count).size(), hue_count);
}

}  // namespace
}  // namespace parallel_aspects
