// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_TEXTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_TEXTS_H

#include <gtest/gtest.h>

#include <string>

namespace parallel_aspects::test {

/// Whether it is in the text, which a failure prints.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  return (text.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "'" << part << "' and the text:\n"
         << text;
}

/// Whether the text begins so, likewise.
inline testing::AssertionResult begins(const std::string& text, const std::string& start) {
  return (text.rfind(start, 0) == 0 ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "'" << start << "' and the text:\n"
         << text;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_TEXTS_H
