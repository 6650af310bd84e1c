// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_COMMAND_RUN_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_COMMAND_RUN_H

#include "tools/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace parallel_aspects::test {

/// What a command line comes to.
struct Outcome {
  int code = 0;
  std::string output;
  std::string messages;
};

inline Outcome run(std::vector<const char*> arguments, const std::atomic<bool>* interrupted = nullptr) {
  std::ostringstream output, messages;
  arguments.insert(arguments.begin(), "aspects");
  const int code = tools::run_command(static_cast<int>(arguments.size()), arguments.data(),
                                      {output, messages, false, interrupted});
  return {code, output.str(), messages.str()};
}

inline std::string contents_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The result of a command that is expected to succeed, and to say nothing besides.
inline nlohmann::json run_json(std::vector<const char*> arguments) {
  arguments.push_back("--json");
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, tools::exit_code::ok) << outcome.messages;
  EXPECT_EQ(outcome.messages, "");
  return nlohmann::json::parse(outcome.output, nullptr, false);
}

inline std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Commands that find the shipped robots in the source tree.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override { setenv("PARALLEL_ASPECTS_SHARE", PARALLEL_ASPECTS_SOURCE_DIR, 1); }
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_COMMAND_RUN_H
