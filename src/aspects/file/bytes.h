// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_BYTES_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace parallel_aspects {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::size_t index_size = 4;  ///< of an index or a count [bytes]

/// Appends numbers as little-endian bytes, on any machine.
class ByteWriter {
 public:
  void put_u8(std::uint8_t value) { bytes_.push_back(value); }
  void put_u32(std::uint32_t value) { put(value); }
  void put_u64(std::uint64_t value) { put(value); }
  void put_double(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    put(bits);
  }
  void put_bytes(const Bytes& bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  void put_text(const std::string& text) {
    put_u32(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

  /// Overwrites eight bytes that were put before.
  void replace_u64(std::size_t at, std::uint64_t value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes_[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
  }

  const Bytes& bytes() const noexcept { return bytes_; }

 private:
  template <class Number>
  void put(Number value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
      bytes_.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  }

  Bytes bytes_;
};

/// Reads them. A caller who asks for more than there is gets zeros, and `ok()` is false from then on.
class ByteReader {
 public:
  /// The bytes must outlive the reader.
  ByteReader(const std::uint8_t* bytes, std::size_t size) noexcept : next_(bytes), left_(size) {}

  bool ok() const noexcept { return ok_; }
  std::size_t left() const noexcept { return left_; }

  std::uint8_t take_u8() noexcept { return take<std::uint8_t>(); }
  std::uint32_t take_u32() noexcept { return take<std::uint32_t>(); }
  std::uint64_t take_u64() noexcept { return take<std::uint64_t>(); }
  double take_double() noexcept {
    const std::uint64_t bits = take_u64();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  /// A number of items of at least `item_size` bytes each that follow; 0 and not `ok()` where so many do not.
  std::size_t take_count(std::size_t item_size) noexcept {
    const std::uint32_t count = take_u32();
    if (count <= left_ / item_size) return count;
    ok_ = false;
    return 0;
  }

  Bytes take_bytes(std::size_t count) {
    if (!has(count)) return {};
    const Bytes result(next_, next_ + count);
    skip(count);
    return result;
  }

  std::string take_text() {
    const std::size_t size = take_count(1);
    const std::string text(next_, next_ + size);
    skip(size);
    return text;
  }

 private:
  bool has(std::size_t size) noexcept {
    ok_ = ok_ && size <= left_;
    return ok_;
  }

  void skip(std::size_t size) noexcept {
    next_ += size;
    left_ -= size;
  }

  template <class Number>
  Number take() noexcept {
    if (!has(sizeof(Number))) return 0;
    Number value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
      value = static_cast<Number>(value | static_cast<Number>(next_[i]) << 8 * i);
    skip(sizeof value);
    return value;
  }

  const std::uint8_t* next_;
  std::size_t left_;
  bool ok_ = true;
};

/// The length, then the bytes as zlib packs them at its fastest: about a seventh of a map.
Bytes packed(const Bytes& bytes);

/// Fills `bytes` with what was packed, or returns why that is impossible, such as "it is damaged". Takes no
/// more memory than zlib can need.
std::string unpack(const Bytes& packed_bytes, Bytes& bytes);

/// Fills `bytes` with a regular file of at most `most` bytes. Empty when done, else why not, such as "it
/// cannot be read: No such file or directory".
std::string read_whole_file(const std::string& path, std::size_t most, Bytes& bytes);

/// Why no file can be written there, such as "is in no folder that can be written to"; empty where one can.
std::string problem_of_writing(const std::string& path);

/// Makes `bytes` the file's whole contents: at every moment, also after a crash, the file is the old one or
/// the new one. A link is followed, and what is no regular file, such as a device, is not touched. Empty when
/// done; else why not, and the old file is untouched.
std::string replace_file(const std::string& name, const Bytes& bytes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_BYTES_H
