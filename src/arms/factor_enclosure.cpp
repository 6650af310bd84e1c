// SPDX-License-Identifier: BSD-3-Clause
#include "arms/factor_enclosure.h"

#include <limits>

namespace parallel_aspects {
namespace {

int compare(double number, const Rational& value) {
  const Rational difference = Rational(number) - value;
  return difference.sign();
}

}  // namespace

Interval enclosure_of(const Rational& value) {
  const auto infinity = std::numeric_limits<double>::infinity();
  double lower = value.convert_to<double>(), upper = lower;
  while (compare(lower, value) > 0) lower = std::nextafter(lower, -infinity);
  while (compare(upper, value) < 0) upper = std::nextafter(upper, infinity);
  return {lower, upper};
}

EnclosedPolynomial::EnclosedPolynomial(const TrigPolynomial& polynomial) {
  for (const auto& [exponents, coefficient] : polynomial.terms()) {
    Term term{enclosure_of(coefficient), {}};
    for (std::size_t place = 0; place < exponents.size(); ++place)
      term.factors.insert(term.factors.end(), exponents[place], static_cast<std::uint8_t>(place));
    terms_.push_back(term);
  }
}

}  // namespace parallel_aspects
