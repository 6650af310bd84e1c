// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"

#include <ios>
#include <locale>
#include <sstream>

namespace parallel_aspects {
namespace {

std::string text_of(double value, int precision, std::ios::fmtflags notation) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(notation, std::ios::floatfield);
  text.precision(precision);
  text << value;
  return text.str();
}

}  // namespace

std::string number_text(double value, int digits) { return text_of(value, digits, {}); }

std::string fixed_number_text(double value, int decimals) {
  return text_of(value, decimals, std::ios::fixed);
}

}  // namespace parallel_aspects
