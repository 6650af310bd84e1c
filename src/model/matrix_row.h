// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_MATRIX_ROW_H
#define PARALLEL_ASPECTS_MODEL_MATRIX_ROW_H

#include "model/task_space_traits.h"

#include <cstddef>

namespace parallel_aspects {

/// Writes the row of A of a leg: the moment b x u, as far as the platform turns, then u, as far as it moves
/// away. b is the anchor seen from the operational point; it is not read where the platform does not turn.
/// The row is linear in u = p - c: give a multiple of u, or one part of a sum. Entries: numbers or
/// enclosures.
template <TaskSpace space, class Arm, class Link, class Row>
void write_row(const Arm& b, const Link& u, Row& row) {
  constexpr TaskSpaceTraits of = traits(space);
  [[maybe_unused]] const auto moment = [&b, &u](std::size_t i, std::size_t k) {
    return b[i] * u[k] - b[k] * u[i];
  };
  if constexpr (of.rotations == 3) {
    row[0] = moment(1, 2);
    row[1] = moment(2, 0);
  }
  if constexpr (of.rotations > 0) row[of.rotations - 1] = moment(0, 1);
  for (std::size_t i = 0; i < of.translations; ++i) row[of.rotations + i] = u[i];
}

/// The same; the row must hold as many entries as the task space has degrees of freedom.
template <class Arm, class Link, class Row>
void write_row(TaskSpace space, const Arm& b, const Link& u, Row& row) {
  with_task_space(space, [&](auto constant) { write_row<decltype(constant)::value>(b, u, row); });
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_MATRIX_ROW_H
