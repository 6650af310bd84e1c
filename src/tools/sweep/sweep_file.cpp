// SPDX-License-Identifier: BSD-3-Clause
#include "tools/sweep/sweep_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace parallel_aspects::tools {

SweepFile::SweepFile(const SweepPlan& plan, const Shard& shard, std::string file) : file_(std::move(file)) {
  open();
  const std::string start =
      header_line({fingerprint(plan), plan.count, shard}) + "\n" + column_line(plan) + "\n";
  const std::string text = contents();
  if (text.size() < start.size()) {
    if (start.compare(0, text.size(), text) != 0) refuse("is of another sweep or none");
    write(start.substr(text.size()));
  } else {
    if (text.compare(0, start.size(), start) != 0)
      refuse("is of another robot, command, shard or version of the package");
    take_rows(plan, shard, text, start.size());
  }
}

SweepFile::Descriptor::~Descriptor() {
  if (number >= 0) close(number);
}

void SweepFile::refuse(const std::string& why) const {
  throw InvalidDescription(
      {"'" + file_ + "' " + why + "; it stays as it is. Give another file, or move this one away."});
}

void SweepFile::open() {
  descriptor_.number = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_.number < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
  if (flock(descriptor_.number, LOCK_EX | LOCK_NB) != 0) refuse("is being written by another process");
}

std::string SweepFile::contents() const {
  std::string text;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = read(descriptor_.number, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// What follows the last line end is of a row that was cut off.
void SweepFile::take_rows(const SweepPlan& plan, const Shard& shard, const std::string& text,
                          std::size_t at) {
  for (std::size_t end = text.find('\n', at); end != std::string::npos; end = text.find('\n', at)) {
    if (rows_ == shard.rows(plan.count)) refuse("has more rows than its sweep");
    const std::string start = row_start(plan, shard.design(rows_));
    if (text.compare(at, start.size(), start) != 0 ||
        !is_row_of(column_line(plan), text.substr(at, end - at)))
      refuse("has another row " + std::to_string(rows_ + 1) + " than its sweep");
    at = end + 1;
    ++rows_;
  }
  if (ftruncate(descriptor_.number, static_cast<off_t>(at)) != 0)
    refuse(std::string("cannot be written: ") + std::strerror(errno));
}

void SweepFile::write(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor_.number, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(std::string("cannot be written: ") + std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
}

void SweepFile::add(const std::string& row) {
  write(row + "\n");
  ++rows_;
}

}  // namespace parallel_aspects::tools
