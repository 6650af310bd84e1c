// SPDX-License-Identifier: BSD-3-Clause
#include "arms/trig_polynomial.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// By falling or rising degree? Rising: coefficient i belongs to cos(a/2)^(n-i) sin(a/2)^i, of n + 1 of them.
using HalfAngleForm = std::vector<Rational>;

HalfAngleForm product(const HalfAngleForm& a, const HalfAngleForm& b) {
  HalfAngleForm result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) result[i + k] += a[i] * b[k];
  return result;
}

HalfAngleForm power(const HalfAngleForm& base, std::size_t exponent) {
  HalfAngleForm result{1};
  for (std::size_t i = 0; i < exponent; ++i) result = product(result, base);
  return result;
}

unsigned degree_in(const TrigPolynomial& a, std::size_t joint) {
  unsigned degree = 0;
  for (const auto& term : a.terms())
    degree = std::max<unsigned>(degree, term.first[2 * joint] + term.first[2 * joint + 1]);
  return degree;
}

// Of a polynomial in one joint, of degree 2 `degree`.
HalfAngleForm half_angle_form(const TrigPolynomial& a, std::size_t joint, unsigned degree) {
  const HalfAngleForm one{1, 0, 1}, cosine{1, 0, -1}, sine{0, 2, 0};
  HalfAngleForm result(2 * degree + 1);
  for (const auto& [exponents, coefficient] : a.terms()) {
    const unsigned cosines = exponents[2 * joint], sines = exponents[2 * joint + 1];
    const HalfAngleForm form =
        product(product(power(cosine, cosines), power(sine, sines)), power(one, degree - cosines - sines));
    for (std::size_t i = 0; i < form.size(); ++i) result[i] += coefficient * form[i];
  }
  return result;
}

// Of a form of even degree.
TrigPolynomial in_full_angle(const HalfAngleForm& form, std::size_t joint) {
  const TrigPolynomial c = TrigPolynomial::cosine(joint), s = TrigPolynomial::sine(joint);
  const TrigPolynomial half(Rational(1, 2));
  const TrigPolynomial cosine_squared = half * (TrigPolynomial(1) + c), mixed = half * s,
                       sine_squared = half * (TrigPolynomial(1) - c);
  TrigPolynomial result;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == 0) continue;
    std::size_t sines = i, cosines = form.size() - 1 - i;
    TrigPolynomial term(form[i]);
    if (sines % 2 != 0) term = term * mixed, --sines, --cosines;
    for (; sines > 0; sines -= 2) term = term * sine_squared;
    for (; cosines > 0; cosines -= 2) term = term * cosine_squared;
    result = result + term;
  }
  return result;
}

// A polynomial in t = tan(a/2), without leading zeros, and how many of these there were.
void trim(HalfAngleForm& form) {
  while (!form.empty() && form.back() == 0) form.pop_back();
}

HalfAngleForm remainder(HalfAngleForm a, const HalfAngleForm& b, HalfAngleForm* quotient = nullptr) {
  if (quotient != nullptr) quotient->assign(a.size() >= b.size() ? a.size() - b.size() + 1 : 1, 0);
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    const std::size_t shift = a.size() - b.size();
    if (quotient != nullptr) (*quotient)[shift] = factor;
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] -= factor * b[i];
    a.pop_back();
    trim(a);
  }
  return a;
}

HalfAngleForm common_divisor(HalfAngleForm a, HalfAngleForm b) {
  while (!b.empty()) {
    HalfAngleForm rest = remainder(std::move(a), b);
    a = std::move(b);
    b = std::move(rest);
  }
  const Rational leading = a.back();
  for (Rational& each : a) each /= leading;
  return a;
}

// The greatest common divisor of forms of one degree, without 1 + t^2, which has no real zero. Zeros at half
// a turn, where t is infinite, are leading zeros of all.
HalfAngleForm common_form(const std::vector<HalfAngleForm>& forms) {
  std::size_t at_half_turn = forms.front().size();
  HalfAngleForm divisor;
  for (HalfAngleForm form : forms) {
    const std::size_t size = form.size();
    trim(form);
    at_half_turn = std::min(at_half_turn, size - form.size());
    divisor = divisor.empty() ? common_divisor(form, {}) : common_divisor(divisor, form);
  }
  const HalfAngleForm one{1, 0, 1};
  for (HalfAngleForm quotient; divisor.size() > 2;) {
    HalfAngleForm rest = remainder(divisor, one, &quotient);
    if (!rest.empty()) break;
    divisor = quotient;
  }
  divisor.resize(divisor.size() + at_half_turn);
  return divisor;
}

HalfAngleForm divided(HalfAngleForm form, HalfAngleForm divisor) {
  const std::size_t size = form.size() - divisor.size() + 1;
  trim(form);
  trim(divisor);
  HalfAngleForm quotient;
  remainder(form, divisor, &quotient);
  quotient.resize(size);
  return quotient;
}

Exponents part_of(const Exponents& exponents, const std::vector<std::size_t>& joints, bool of_these) {
  Exponents result{};
  for (std::size_t joint = 0; joint < max_arm_joints; ++joint) {
    if ((std::find(joints.begin(), joints.end(), joint) != joints.end()) != of_these) continue;
    result[2 * joint] = exponents[2 * joint];
    result[2 * joint + 1] = exponents[2 * joint + 1];
  }
  return result;
}

}  // namespace

bool TrigPolynomial::depends_on(std::size_t joint) const noexcept {
  return std::any_of(terms_.begin(), terms_.end(), [joint](const auto& term) {
    return term.first[2 * joint] != 0 || term.first[2 * joint + 1] != 0;
  });
}

std::vector<std::size_t> TrigPolynomial::joints() const {
  std::vector<std::size_t> result;
  for (std::size_t joint = 0; joint < max_arm_joints; ++joint)
    if (depends_on(joint)) result.push_back(joint);
  return result;
}

void TrigPolynomial::add(const Exponents& exponents, const Rational& coefficient) {
  if (coefficient == 0) return;
  const auto [place, is_new] = terms_.emplace(exponents, coefficient);
  if (is_new) return;
  place->second += coefficient;
  if (place->second == 0) terms_.erase(place);
}

// Products of two sines of one angle become 1 - cos^2.
void TrigPolynomial::add_product(const Exponents& a, const Exponents& b, const Rational& coefficient) {
  Exponents sum{};
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<std::uint8_t>(a[i] + b[i]);
  std::vector<std::pair<Exponents, Rational>> open{{sum, coefficient}};
  for (std::size_t sine = 1; sine < sum.size(); sine += 2) {
    if (sum[sine] < 2) continue;
    const std::size_t count = open.size();
    for (std::size_t i = 0; i < count; ++i) {
      open[i].first[sine] = static_cast<std::uint8_t>(open[i].first[sine] - 2);
      auto with_cosines = open[i];
      with_cosines.first[sine - 1] = static_cast<std::uint8_t>(with_cosines.first[sine - 1] + 2);
      with_cosines.second = -with_cosines.second;
      open.push_back(std::move(with_cosines));
    }
  }
  for (const auto& [exponents, value] : open) add(exponents, value);
}

TrigPolynomial operator*(const TrigPolynomial& a, const TrigPolynomial& b) {
  TrigPolynomial result;
  for (const auto& [ones, one] : a.terms_)
    for (const auto& [others, other] : b.terms_) result.add_product(ones, others, one * other);
  return result;
}

TrigPolynomial TrigPolynomial::derivative(std::size_t joint, bool turns) const {
  const std::size_t at = 2 * joint;
  TrigPolynomial result;
  const auto times = [&](Exponents exponents, int cosines, int sines, const Rational& coefficient) {
    exponents[at] = static_cast<std::uint8_t>(cosines);
    exponents[at + 1] = 0;
    Exponents factor{};
    factor[at + 1] = static_cast<std::uint8_t>(sines);
    result.add_product(exponents, factor, coefficient);
  };
  for (const auto& [exponents, coefficient] : terms_) {
    const int cosines = exponents[at], sines = exponents[at + 1];
    if (cosines > 0)
      times(exponents, cosines - 1, turns ? sines + 1 : 0, coefficient * (turns ? -cosines : cosines));
    if (sines > 0) times(exponents, cosines + 1, sines - 1, coefficient * sines);
  }
  return result;
}

std::map<Exponents, TrigPolynomial> by_other_joints(const TrigPolynomial& a, std::size_t joint) {
  std::map<Exponents, TrigPolynomial> result;
  for (const auto& [exponents, coefficient] : a.terms())
    result[part_of(exponents, {joint}, false)].add(part_of(exponents, {joint}, true), coefficient);
  return result;
}

Content content_in(const TrigPolynomial& a, std::size_t joint) {
  const unsigned degree = degree_in(a, joint);
  if (degree == 0) return {1, a};
  const auto parts = by_other_joints(a, joint);
  std::vector<HalfAngleForm> forms;
  for (const auto& part : parts) forms.push_back(half_angle_form(part.second, joint, degree));
  const HalfAngleForm common = common_form(forms);
  if (common.size() < 3 || common.size() % 2 == 0) return {1, a};
  Content content{in_full_angle(common, joint), {}};
  std::size_t next = 0;
  for (const auto& part : parts) {
    TrigPolynomial monomial;
    monomial.add(part.first, 1);
    content.rest = content.rest + monomial * in_full_angle(divided(forms[next++], common), joint);
  }
  return content;
}

std::vector<TrigPolynomial> split(const TrigPolynomial& a, const std::vector<std::size_t>& joints) {
  std::map<Exponents, TrigPolynomial> rows;  // by the monomial in `joints`
  for (const auto& [exponents, coefficient] : a.terms())
    rows[part_of(exponents, joints, true)].add(part_of(exponents, joints, false), coefficient);
  const TrigPolynomial& first = rows.begin()->second;
  const auto& [pivot, pivot_value] = *first.terms().begin();
  TrigPolynomial factor;
  for (const auto& [monomial, row] : rows) {
    const auto found = row.terms().find(pivot);
    if (found == row.terms().end()) return {};
    const Rational ratio = found->second / pivot_value;
    if (!(row == first * TrigPolynomial(ratio))) return {};
    factor.add(monomial, ratio);
  }
  return {factor, first};
}

}  // namespace parallel_aspects
