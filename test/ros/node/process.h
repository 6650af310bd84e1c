// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_PROCESS_H
#define PARALLEL_ASPECTS_TEST_ROS_PROCESS_H

#include "ros/node/node_client.h"

#include <csignal>
#include <optional>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <utility>
#include <vector>

extern char** environ;

namespace parallel_aspects::test {

/// A program, of PATH or with its path; a node in a namespace of its own, where one is given.
class Process {
 public:
  Process(std::string program, const std::string& name_space, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{std::move(program)};
    if (!name_space.empty()) words.push_back("__ns:=" + name_space);
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (posix_spawnp(&id_, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) id_ = -1;
  }
  ~Process() {
    if (id_ > 0 && !status_) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Asks it to end as Ctrl-C does. Its exit status, -1 after a signal; nothing where it does not end in
  /// time.
  std::optional<int> end() {
    kill(id_, SIGINT);
    eventually([this] { return has_ended(); });
    return status_;
  }

  /// SIGSTOP, SIGCONT, SIGKILL and the like.
  void signal(int number) const { kill(id_, number); }

  bool has_ended() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, WNOHANG) == id_)
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return status_.has_value();
  }

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_PROCESS_H
