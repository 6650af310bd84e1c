// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <locale>

namespace parallel_aspects {
namespace {

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class NumberText : public testing::Test {
 protected:
  NumberText() : before_(std::locale::global(std::locale(std::locale::classic(), new DecimalComma))) {}
  ~NumberText() override { std::locale::global(before_); }

 private:
  std::locale before_;
};

TEST_F(NumberText, HasNoDigitsThatSayNothing) {
  EXPECT_EQ(number_text(0.5), "0.5");
  EXPECT_EQ(number_text(-3.0), "-3");
  EXPECT_EQ(number_text(1234567.0), "1.23457e+06");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(2.0 / 3.0, 3), "0.667");
}

TEST_F(NumberText, GivesEveryNumberBack) {
  for (const double value : {0.1, 1.0 / 3.0, 12345.678, 2.3e-308, -1.7e308, std::nextafter(1.0, 2.0)}) {
    const std::string text = number_text(value, exact_digits);
    EXPECT_EQ(std::stod(text), value) << text;
  }
}

TEST_F(NumberText, HasAFixedNumberOfDecimals) {
  EXPECT_EQ(fixed_number_text(0.5, 2), "0.50");
  EXPECT_EQ(fixed_number_text(12345.678, 2), "12345.68");
}

}  // namespace
}  // namespace parallel_aspects
