// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/marker_colors.h"

namespace parallel_aspects {
namespace {

float mixed(float from, float to, double share) { return static_cast<float>(from + share * (to - from)); }

}  // namespace

std_msgs::ColorRGBA color(Rgb rgb) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(rgb >> 16U & 0xFFU) / 255.0F;
  result.g = static_cast<float>(rgb >> 8U & 0xFFU) / 255.0F;
  result.b = static_cast<float>(rgb & 0xFFU) / 255.0F;
  result.a = 1.0F;
  return result;
}

Rgb candidate_rgb(std::size_t index) { return aspect_color(-1, index); }

std_msgs::ColorRGBA candidate_color(std::size_t index) { return color(candidate_rgb(index)); }

std_msgs::ColorRGBA lightened(const std_msgs::ColorRGBA& color, double share) {
  std_msgs::ColorRGBA result = color;
  result.r = mixed(color.r, 1.0F, share);
  result.g = mixed(color.g, 1.0F, share);
  result.b = mixed(color.b, 1.0F, share);
  return result;
}

std_msgs::ColorRGBA readable_on(const std_msgs::ColorRGBA& background) {
  const double luminance = 0.299 * background.r + 0.587 * background.g + 0.114 * background.b;
  return color(luminance > 0.5 ? 0x000000 : 0xFFFFFF);
}

}  // namespace parallel_aspects
