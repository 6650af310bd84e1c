// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_NUMBER_TEXT_H
#define PARALLEL_ASPECTS_MODEL_NUMBER_TEXT_H

#include <string>

namespace parallel_aspects {

/// Digits that tell every double from all others.
inline constexpr int exact_digits = 17;

/// A number as people write it, "0.5" or "1e-09", with at most so many significant digits. The same in every
/// locale, as files and other programs have to read it.
std::string number_text(double value, int digits = 6);

/// The same with so many digits after the point: "0.50".
std::string fixed_number_text(double value, int decimals);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_NUMBER_TEXT_H
