// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/status_words.h"

#include <cstdio>

namespace parallel_aspects {

std::string words_of(const PictureThread::Result& result, const std::string& said) {
  if (!result.problem.empty()) return result.problem;
  if (result.has_volumes && !result.map)
    return "Maps the positions at the present orientation, once the robot is tracked.";
  if (!result.map) return said.empty() ? "Waits for the node." : said;
  char words[240];
  std::snprintf(words, sizeof words, "%zu aspects, %.1f MB in %.2f s; %zu triangles drawn in %.2f s",
                result.map->map->aspects().size(), static_cast<double>(result.map->bytes) / 1e6,
                result.fetch_seconds, result.picture ? result.picture->triangles : 0, result.draw_seconds);
  if (!result.has_volumes) return words;
  return "Positions at one orientation, mapped here, of which parts may be joined by turning: " +
         std::string(words);
}

std::string words_of_unknown(const std::set<int>& candidates, bool mode_was_known) {
  if (candidates.empty())
    return mode_was_known ? "Drawn is the working mode that was known last."
                          : "No aspect is drawn; set Shown to All to see them.";
  std::string words = "Drawn is where it may be: aspect ";
  for (const int id : candidates) words += (id == *candidates.begin() ? "" : ", ") + std::to_string(id);
  return words + ". Choose one in the panel.";
}

}  // namespace parallel_aspects
