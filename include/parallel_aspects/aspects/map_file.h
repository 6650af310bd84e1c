// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_FILE_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_FILE_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether a map was written.
struct SaveResult {
  bool saved = false;   ///< the file is whole and on the disk
  std::string message;  ///< why not, unless saved

  explicit operator bool() const noexcept { return saved; }  ///< whether it was written
};

/// Why a map cannot be saved there, such as "is in no folder that can be written to"; empty where it can.
/// What is no map is not written over.
std::string problem_of_saving(const std::string& path);

/// Writes the map to a file, and its graph of aspects if that is known (`compute_aspect_graph`): who loads it
/// need not look for gates again. At every moment the file is the old one or the new one, whole.
SaveResult save_map(const AspectMap& map, const std::string& path);

/// The map of this manipulator with these options, as `compute_aspect_map` gave it, if the file holds that;
/// where `complete` is not asked for, one that is will do.
/// Refused with a message where it cannot be read, is damaged, is of another version of the package or
/// another revision of the proofs, or holds the map of another robot or of other options. What the file
/// claims is believed then, so it is as good as those who can write to it; but no file, not even a forged
/// one, does harm beyond wrong answers.
MapResult load_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                   const std::string& path);

/// The file that `save_map` writes, packed by zlib behind its length, a little-endian number of eight bytes.
std::vector<std::uint8_t> map_bytes(const AspectMap& map);

/// The map that such bytes are of, refused like a file.
MapResult map_from_bytes(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                         const std::vector<std::uint8_t>& bytes);

/// Options that the map is loaded with, for whoever does not know those that it was computed with.
MapOptions options_of(const AspectMap& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_FILE_H
