// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/bytes.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <zlib.h>

namespace parallel_aspects {

Bytes packed(const Bytes& bytes) {
  ByteWriter writer;
  writer.put_u64(bytes.size());
  Bytes result = writer.bytes();
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  const std::size_t start = result.size();
  result.resize(start + size);
  compress2(result.data() + start, &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_BEST_SPEED);
  result.resize(start + size);
  return result;
}

std::string unpack(const Bytes& packed_bytes, Bytes& bytes) {
  constexpr std::size_t best_ratio = 1100;
  ByteReader reader(packed_bytes.data(), packed_bytes.size());
  const std::uint64_t length = reader.take_u64();
  if (!reader.ok() || length > best_ratio * reader.left()) return "it is cut off";
  bytes.resize(length);
  auto size = static_cast<uLongf>(length);
  const int result =
      uncompress(bytes.data(), &size, packed_bytes.data() + packed_bytes.size() - reader.left(),
                 static_cast<uLong>(reader.left()));
  return result == Z_OK && size == length ? "" : "it is damaged";
}

namespace {

constexpr mode_t readable_by_all = 0644;

std::string failure(const std::string& what) {
  return "it cannot be " + what + ": " + std::generic_category().message(errno);
}

/// An open file, closed at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number) noexcept : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const noexcept { return number_; }
  bool is_open() const noexcept { return number_ >= 0; }
  bool close() noexcept {
    const int number = number_;
    number_ = -1;
    return number < 0 || ::close(number) == 0;
  }

 private:
  int number_;
};

bool write_all(int file, const Bytes& bytes) noexcept {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = write(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return true;
}

/// Shortens `bytes` where the file is shorter than them.
bool read_all(int file, Bytes& bytes) noexcept {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = read(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) return false;
    if (count == 0) break;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return true;
}

/// The new name is on the disk too. Not every file system can do that; the file is whole without it.
void store_name(const std::filesystem::path& folder) noexcept {
  const Descriptor directory(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) fsync(directory.number());
}

bool write_and_rename(Descriptor& file, const std::string& temporary, const std::string& path,
                      const Bytes& bytes) noexcept {
  return write_all(file.number(), bytes) && fchmod(file.number(), readable_by_all) == 0 &&
         fsync(file.number()) == 0 && file.close() && std::rename(temporary.c_str(), path.c_str()) == 0;
}

}  // namespace

std::string problem_of_writing(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
    return "is in no folder that can be written to";
  return fs::exists(path, error) && !fs::is_regular_file(path, error) ? "is not a regular file" : "";
}

std::string read_whole_file(const std::string& path, std::size_t most, Bytes& bytes) {
  // Without O_NONBLOCK a pipe would wait for its other end.
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!file.is_open() || fstat(file.number(), &status) != 0) return failure("read");
  if (!S_ISREG(status.st_mode)) return "it is not a regular file";
  if (static_cast<std::size_t>(status.st_size) > most) return "it is too large to be a map";
  bytes.resize(static_cast<std::size_t>(status.st_size));
  return read_all(file.number(), bytes) ? "" : failure("read");
}

std::string replace_file(const std::string& name, const Bytes& bytes) {
  std::error_code missing;
  const std::filesystem::path target = std::filesystem::canonical(name, missing);
  const std::string path = missing ? name : target.string();
  if (!missing && !std::filesystem::is_regular_file(target, missing)) return "it is not a regular file";
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::string temporary = path + ".XXXXXX";
  Descriptor file(mkostemp(temporary.data(), O_CLOEXEC));
  if (!file.is_open()) return failure("written");
  if (!write_and_rename(file, temporary, path, bytes)) {
    std::string why = failure("written");
    unlink(temporary.c_str());
    return why;
  }
  store_name(folder.empty() ? "." : folder);
  return "";
}

}  // namespace parallel_aspects
