// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/report.h"

#include <gtest/gtest.h>

namespace parallel_aspects::tools {
namespace {

TEST(TextTable, AlignsItsColumns) {
  TextTable table({">id", "name", "note"});
  table.add({"1", "long name", ""});
  table.add({"10", "n", "x"});
  EXPECT_EQ(table.text(),
            "id  name       note\n"
            " 1  long name\n"
            "10  n          x\n");
}

TEST(TextTable, MissingCellsAreEmpty) {
  TextTable table({"a", "b"});
  table.add({"1"});
  EXPECT_EQ(table.text(), "a  b\n1\n");
}

}  // namespace
}  // namespace parallel_aspects::tools
