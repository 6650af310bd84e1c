// SPDX-License-Identifier: BSD-3-Clause
//
// Main of the programs that hold the tests of a room.
#include <gtest/gtest.h>

#include "main/tests_of_file.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  parallel_aspects::test::choose_tests_of_file(argc, argv);
  return RUN_ALL_TESTS();
}
