// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_PANEL_TONE_COLORS_H
#define PARALLEL_ASPECTS_RVIZ_PANEL_TONE_COLORS_H

#include "rviz/panel/panel_model.h"

#include <QColor>

namespace parallel_aspects {

/// Colours that people with any colour vision tell apart (after Paul Tol's "high contrast" scheme).
inline QColor color_of(Tone tone) {
  switch (tone) {
    case Tone::clear:
      return QColor(0x00, 0x44, 0x88);
    case Tone::warn:
      return QColor(0xDD, 0xAA, 0x33);
    case Tone::stop:
      return QColor(0xBB, 0x55, 0x66);
    case Tone::unknown:
      break;
  }
  return QColor(0x77, 0x77, 0x77);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_PANEL_TONE_COLORS_H
