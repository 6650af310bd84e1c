// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/caption.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace parallel_aspects {
namespace {

// Lines of at most this many letters, broken at blanks.
void add_lines(const std::string& line, std::size_t longest, std::vector<std::string>& lines) {
  std::istringstream stream(line);
  std::string word, current;
  while (stream >> word) {
    if (!current.empty() && current.size() + 1 + word.size() > longest) {
      lines.push_back(current);
      current.clear();
    }
    current += (current.empty() ? "" : " ") + word;
  }
  lines.push_back(current);
}

std::vector<std::string> lines_of(const std::string& words, std::size_t longest) {
  std::vector<std::string> lines;
  std::istringstream stream(words);
  for (std::string line; std::getline(stream, line);) add_lines(line, longest, lines);
  if (lines.size() <= Caption::max_lines) return lines;
  lines.resize(Caption::max_lines);
  std::string& last = lines.back();
  if (last.size() + 4 > longest) last.erase(std::min(last.find_last_of(' ', longest - 4), longest - 4));
  last += " ...";
  return lines;
}

}  // namespace

Caption caption_of(const Scene& scene, const std::string& words) {
  const Eigen::AlignedBox3d& robot = scene.robot;
  Caption caption;
  caption.text_height = 0.04 * scene.tiles.height();
  const double text = caption.text_height;
  // Of a planar robot, below it; of any other, above it and the gallery, in the plane of the gallery.
  const double left = scene.planar ? robot.min().x() : robot.min().x() - scene.gallery.translation().x();
  const double right = scene.planar ? robot.max().x() : scene.tiles.width();
  const auto longest =
      static_cast<std::size_t>(std::max(12.0, (right - left) / (Caption::letter_width * text)));
  const std::vector<std::string> lines = lines_of(words, longest);
  for (const std::string& line : lines) caption.words += (caption.words.empty() ? "" : "\n") + line;
  const double half = 0.5 * Caption::line_pitch * text * static_cast<double>(lines.size());
  const double middle = 0.5 * (left + right);
  caption.at = scene.planar ? Eigen::Vector3d(middle, robot.min().y() - 0.8 * text - half, 0.0)
                            : scene.gallery * Eigen::Vector3d(middle, 2.0 * text + half, 0.0);
  return caption;
}

}  // namespace parallel_aspects
