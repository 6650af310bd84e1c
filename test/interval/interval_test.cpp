// SPDX-License-Identifier: BSD-3-Clause
#include "interval/interval.h"

#include <gtest/gtest.h>
#include <mpfi.h>

#include <functional>
#include <random>

namespace parallel_aspects {
namespace {

/// An interval of the MPFI library with 200 bits: what intervals of doubles must enclose.
class Reference {
 public:
  Reference() { mpfi_init2(value_, 200); }
  explicit Reference(const Interval& a) : Reference() { mpfi_interv_d(value_, a.lower(), a.upper()); }
  ~Reference() { mpfi_clear(value_); }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  mpfi_ptr get() { return value_; }

  bool enclosed_in(const Interval& a) { return mpfi_cmp_d_lower(a.lower()) && mpfi_cmp_d_upper(a.upper()); }

  double width() {
    mpfr_t diameter;
    mpfr_init2(diameter, 200);
    mpfi_diam_abs(diameter, value_);
    const double result = mpfr_get_d(diameter, MPFR_RNDU);
    mpfr_clear(diameter);
    return result;
  }

 private:
  bool mpfi_cmp_d_lower(double lower) { return mpfr_cmp_d(&value_->left, lower) >= 0; }
  bool mpfi_cmp_d_upper(double upper) { return mpfr_cmp_d(&value_->right, upper) <= 0; }

  mpfi_t value_;
};

class RandomIntervals {
 public:
  Interval next() {
    std::uniform_int_distribution<int> exponent(-20, 20), kind(0, 5);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    const double a = std::ldexp(mantissa(random_), exponent(random_));
    const double b = std::ldexp(mantissa(random_), exponent(random_));
    switch (kind(random_)) {
      case 0:
        return Interval(a);
      case 1:
        return {std::min(a, 0.0), std::max(a, 0.0)};
      default:
        return {std::min(a, b), std::max(a, b)};
    }
  }

 private:
  std::mt19937_64 random_{42};
};

std::string pasted(const Interval& a) {
  char buffer[100];
  std::snprintf(buffer, sizeof(buffer), "Interval(%a, %a)", a.lower(), a.upper());
  return buffer;
}

constexpr int trials = 300000;

// Upward rounding must not reach MPFI, which takes care of its own.
template <class Operation>
Interval rounded(const Operation& operation) {
  const RoundingUpward rounding;
  return operation();
}

void check_binary(const std::function<Interval(const Interval&, const Interval&)>& ours,
                  const std::function<void(mpfi_ptr, mpfi_ptr, mpfi_ptr)>& theirs) {
  RandomIntervals random;
  for (int i = 0; i < trials; ++i) {
    const Interval a = random.next(), b = random.next();
    const Interval result = rounded([&] { return ours(a, b); });
    Reference x(a), y(b), exact;
    theirs(exact.get(), x.get(), y.get());
    ASSERT_TRUE(exact.enclosed_in(result)) << pasted(a) << ", " << pasted(b) << " -> " << pasted(result);
    const double magnitude = std::max(std::abs(result.lower()), std::abs(result.upper()));
    ASSERT_LE(result.upper() - result.lower(), exact.width() + 0x1p-51 * magnitude + 1e-300)
        << pasted(a) << ", " << pasted(b) << " -> " << pasted(result);
  }
}

void check_unary(const std::function<Interval(const Interval&)>& ours,
                 const std::function<void(mpfi_ptr, mpfi_ptr)>& theirs,
                 const std::function<bool(const Interval&)>& in_domain) {
  RandomIntervals random;
  for (int i = 0; i < trials; ++i) {
    const Interval a = random.next();
    if (!in_domain(a)) continue;
    const Interval result = rounded([&] { return ours(a); });
    Reference x(a), exact;
    theirs(exact.get(), x.get());
    ASSERT_TRUE(exact.enclosed_in(result)) << pasted(a) << " -> " << pasted(result);
    const double magnitude = std::max(std::abs(result.lower()), std::abs(result.upper()));
    ASSERT_LE(result.upper() - result.lower(), exact.width() + 0x1p-50 * magnitude + 1e-300) << pasted(a);
  }
}

bool anything(const Interval&) { return true; }

TEST(Interval, SumEnclosesMpfi) {
  check_binary([](const Interval& a, const Interval& b) { return a + b; }, mpfi_add);
}
TEST(Interval, DifferenceEnclosesMpfi) {
  check_binary([](const Interval& a, const Interval& b) { return a - b; }, mpfi_sub);
}
TEST(Interval, ProductEnclosesMpfi) {
  check_binary([](const Interval& a, const Interval& b) { return a * b; }, mpfi_mul);
}
TEST(Interval, SquareEnclosesMpfi) {
  check_unary([](const Interval& a) { return square(a); }, mpfi_sqr, anything);
}
TEST(Interval, SquareRootEnclosesMpfi) {
  check_unary([](const Interval& a) { return square_root(a); }, mpfi_sqrt,
              [](const Interval& a) { return a.lower() >= 0.0; });
}
TEST(Interval, ReciprocalEnclosesMpfi) {
  check_unary([](const Interval& a) { return reciprocal(a); }, mpfi_inv,
              [](const Interval& a) { return a.lower() > 0.0; });
}

TEST(Interval, SignsAreStrict) {
  EXPECT_TRUE(Interval(1e-300, 1.0).positive());
  EXPECT_FALSE(Interval(0.0, 1.0).positive());
  EXPECT_TRUE(Interval(-1.0, -1e-300).negative());
  EXPECT_FALSE(Interval(-1.0, 0.0).negative());
}

TEST(RoundingUpward, EndsWithItsScope) {
  const int before = std::fegetround();
  {
    const RoundingUpward rounding;
    EXPECT_EQ(std::fegetround(), FE_UPWARD);
  }
  EXPECT_EQ(std::fegetround(), before);
}

}  // namespace
}  // namespace parallel_aspects
