// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_MAIN_TESTS_OF_FILE_H
#define PARALLEL_ASPECTS_TEST_MAIN_TESTS_OF_FILE_H

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace parallel_aspects::test {

inline bool is_in_file(const testing::TestInfo& test, const std::string& file) {
  const std::string path = test.file(), ending = file + ".cpp";
  return path.size() >= ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

/// A filter for gtest that takes the tests of this file alone.
inline std::string tests_of_file(const std::string& file) {
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k)
      if (is_in_file(*suite.GetTestInfo(k), file))
        filter += std::string(suite.name()) + "." + suite.GetTestInfo(k)->name() + ":";
  }
  return filter;
}

/// Of a program that holds the tests of a room: with --file=NAME only those of NAME.cpp are run. A name that
/// no test has ends the program, so that none is left out unseen.
inline void choose_tests_of_file(int argc, char** argv) {
  const std::string option = "--file=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind(option, 0) != 0) continue;
    const std::string filter = tests_of_file("/" + argument.substr(option.size()));
    if (filter.empty()) {
      std::cerr << "No test of this program is in " << argument.substr(option.size()) << ".cpp.\n";
      std::exit(EXIT_FAILURE);
    }
    testing::GTEST_FLAG(filter) = filter;
  }
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_MAIN_TESTS_OF_FILE_H
