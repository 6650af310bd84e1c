// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/packed_bytes.h"

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

}  // namespace parallel_aspects
