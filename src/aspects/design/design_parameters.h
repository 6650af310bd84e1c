// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_DESIGN_DESIGN_PARAMETERS_H
#define PARALLEL_ASPECTS_ASPECTS_DESIGN_DESIGN_PARAMETERS_H

#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The kind of number that a parameter of a design is.
enum class DesignPart { crank, rod, inner, outer, base, anchor };

/// Which number of a robot a parameter is.
struct DesignLength {
  DesignPart part = DesignPart::rod;
  std::size_t leg = 0;   ///< from 0
  std::size_t axis = 0;  ///< of base and anchor: 0 for x, 1 for y, 2 for z

  friend bool operator==(const DesignLength& a, const DesignLength& b) {
    return a.part == b.part && a.leg == b.leg && a.axis == b.axis;
  }
};

/// All parameters of a robot, leg by leg.
std::vector<DesignLength> design_lengths(const Manipulator& manipulator);

/// "crank_1", "base_2_x" and so on.
std::string name_of(const DesignLength& length);

/// "crank", "base_x": the name of the number of all legs.
std::string family_of(const DesignLength& length);

/// The number itself; the leg must have it.
double& number_of(Leg& leg, const DesignLength& length);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_DESIGN_DESIGN_PARAMETERS_H
