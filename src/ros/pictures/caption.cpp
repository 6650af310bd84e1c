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

// Of a planar robot, below it; of any other, above it and the gallery, in the plane of the gallery.
struct Room {
  Eigen::Isometry3d frame;
  double left, right, first;  // where the lines begin [m]
  double text;                // height of letters [m]

  double height(std::size_t lines) const { return Caption::line_pitch * text * static_cast<double>(lines); }
};

Room room_of(const Scene& scene) {
  const Eigen::AlignedBox3d& robot = scene.robot;
  const double text = 0.04 * scene.tiles.height();
  if (scene.planar)
    return {Eigen::Isometry3d::Identity(), robot.min().x(), robot.max().x(), robot.min().y() - 0.8 * text,
            text};
  return {scene.gallery, robot.min().x() - scene.gallery.translation().x(), scene.tiles.width(), 2.0 * text,
          text};
}

}  // namespace

Caption caption_of(const Scene& scene, const std::string& words) {
  const Room room = room_of(scene);
  Caption caption;
  caption.text_height = room.text;
  const auto longest = static_cast<std::size_t>(
      std::max(12.0, (room.right - room.left) / (Caption::letter_width * room.text)));
  const std::vector<std::string> lines = lines_of(words, longest);
  for (const std::string& line : lines) caption.words += (caption.words.empty() ? "" : "\n") + line;
  const double half = 0.5 * room.height(lines.size());
  const double middle = 0.5 * (room.left + room.right);
  caption.at = room.frame * Eigen::Vector3d(middle, room.first + (scene.planar ? -half : half), 0.0);
  return caption;
}

std::vector<Eigen::Vector3d> caption_corners(const Scene& scene) {
  const Room room = room_of(scene);
  const double height = room.height(Caption::max_lines);
  const double last = room.first + (scene.planar ? -height : height);
  return {room.frame * Eigen::Vector3d(room.left, room.first, 0.0),
          room.frame * Eigen::Vector3d(room.right, last, 0.0)};
}

}  // namespace parallel_aspects
