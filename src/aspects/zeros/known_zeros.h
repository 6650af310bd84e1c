// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_ZEROS_KNOWN_ZEROS_H
#define PARALLEL_ASPECTS_ASPECTS_ZEROS_KNOWN_ZEROS_H

#include "parallel_aspects/aspects/box.h"

#include <vector>

namespace parallel_aspects {

/// A zero of two functions over a slice, or, where these depend on parameters, one for each value of them.
struct KnownZero {
  Box unique;     ///< holds this zero and no other [half turns]
  Box enclosure;  ///< of it
};

/// Zeros that are proved, no two of them the same.
class KnownZeros {
 public:
  const std::vector<KnownZero>& all() const noexcept { return zeros_; }

  /// Whether a box that holds one known zero and no other holds all of this one.
  bool cover(const Box& box) const noexcept;

  /// Adds the zero, if it is new. False where it is not proved that it is, nor that it is known.
  bool note(const KnownZero& found);

 private:
  std::vector<KnownZero> zeros_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_ZEROS_KNOWN_ZEROS_H
