// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_CONSOLE_CAPTURE_H
#define PARALLEL_ASPECTS_URDF_READING_CONSOLE_CAPTURE_H

#include <console_bridge/console.h>
#include <string>

namespace parallel_aspects {

/// Keeps what urdfdom would print, for as long as it lives.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  ConsoleCapture() { console_bridge::useOutputHandler(this); }
  ~ConsoleCapture() override { console_bridge::restorePreviousOutputHandler(); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_error.empty()) first_error = text;
  }

  std::string first_error;  ///< empty where there was none
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_CONSOLE_CAPTURE_H
