// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_RVIZ_SCREEN_H
#define PARALLEL_ASPECTS_TEST_RVIZ_SCREEN_H

#include "ros/node/process.h"

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <unistd.h>

namespace parallel_aspects::test {

/// A screen in memory for this process and those that it starts. Lives as long as the object.
class Screen {
 public:
  Screen() {
    std::array<int, 2> ends{-1, -1};  // what Xvfb writes its number to
    if (pipe(ends.data()) != 0) return;
    server_ =
        std::make_unique<Process>("Xvfb", "",
                                  std::vector<std::string>{"-displayfd", std::to_string(ends[1]), "-screen",
                                                           "0", "1280x800x24", "-nolisten", "tcp"});
    close(ends[1]);
    char letter = 0;
    std::string number;
    while (read(ends[0], &letter, 1) == 1 && letter != '\n') number += letter;
    close(ends[0]);
    if (number.empty()) return;
    setenv("DISPLAY", (":" + number).c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("QT_X11_NO_MITSHM", "1", 1);
    setenv("QT_QPA_PLATFORM", "xcb", 1);
    unsetenv("WAYLAND_DISPLAY");
    is_there_ = true;
  }

  bool is_there() const { return is_there_; }

 private:
  std::unique_ptr<Process> server_;
  bool is_there_ = false;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_RVIZ_SCREEN_H
