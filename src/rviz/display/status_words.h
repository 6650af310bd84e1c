// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_STATUS_WORDS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_STATUS_WORDS_H

#include "rviz/display/picture_thread.h"

#include <set>
#include <string>

namespace parallel_aspects {

/// What a display says of its map. `said`: what the node said of it.
std::string words_of(const PictureThread::Result& result, const std::string& said);

/// What it draws of a robot of which the aspect is not known: these, where there are candidates.
std::string words_of_unknown(const std::set<int>& candidates, bool mode_was_known);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_STATUS_WORDS_H
