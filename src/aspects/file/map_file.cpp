// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/bytes.h"
#include "aspects/file/map_key.h"
#include "aspects/file/map_record.h"
#include "aspects/map/map_contents.h"
#include "aspects/map/map_plan.h"
#include "aspects/map/proof_revision.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/version.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <utility>
#include <zlib.h>

// A file: magic, format version, its whole length, version of the package, revision of the proofs, key
// (`map_key`), the record (map_record.cpp), and last the CRC-32 of everything before. All numbers are
// little-endian.
namespace parallel_aspects {
namespace {

constexpr std::array<std::uint8_t, 8> magic{'A', 'S', 'P', 'E', 'C', 'T', 'S', 0x1a};
constexpr std::uint32_t format_version = 5;
constexpr std::size_t checksum_size = 4;
constexpr std::size_t largest_file = std::size_t{1} << 32;

std::uint32_t checksum(const Bytes& bytes, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), size));
}

Bytes encode(const AspectMap::Contents& map) {
  ByteWriter writer;
  for (const std::uint8_t byte : magic) writer.put_u8(byte);
  writer.put_u32(format_version);
  const std::size_t length_at = writer.bytes().size();
  writer.put_u64(0);
  writer.put_text(package_version);
  writer.put_u32(proof_revision);
  writer.put_text(map_key(*map.manipulator, map.tree.region(), map.resolution, map.depth, map.deepest_level) +
                  coverage_key(map.slice, map.modes));
  write_record(map, writer);
  writer.replace_u64(length_at, writer.bytes().size() + checksum_size);
  writer.put_u32(checksum(writer.bytes(), writer.bytes().size()));
  return writer.bytes();
}

/// Why the file cannot be of any use to this package; empty where it can. `reader` is behind the versions
/// then.
std::string find_damage(const Bytes& file, ByteReader& reader) {
  const Bytes start = reader.take_bytes(magic.size());
  if (!std::equal(magic.begin(), magic.end(), start.begin(), start.end())) return "it is not a map file";
  const std::uint32_t version = reader.take_u32();
  if (reader.ok() && version != format_version)
    return "its format is version " + std::to_string(version) + " and not " + std::to_string(format_version);
  const std::uint64_t length = reader.take_u64();
  if (!reader.ok() || length != file.size()) return "it is cut off or too long";
  ByteReader last(file.data() + file.size() - checksum_size, checksum_size);
  if (last.take_u32() != checksum(file, file.size() - checksum_size))
    return "it is damaged: its checksum is wrong";
  const std::string written_by = reader.take_text();
  if (written_by != package_version)
    return "it was written by version '" + written_by + "' of the package and not " + package_version;
  const std::uint32_t revision = reader.take_u32();
  return revision == proof_revision ? ""
                                    : "it was computed by revision " + std::to_string(revision) +
                                          " of the proofs and not " + std::to_string(proof_revision);
}

std::string find_other_key(const std::string& held, const std::string& asked) {
  if (held == asked) return "";
  const std::string of_file = line_missing_in(asked, held), of_question = line_missing_in(held, asked);
  if (of_file.empty()) return "it holds a map without \"" + of_question + "\"";
  return "it holds a map with \"" + of_file + "\"" +
         (of_question.empty() ? ", which is not asked for" : " and not \"" + of_question + "\"");
}

/// Fills `map`, or returns why the file does not hold it.
std::string decode(std::shared_ptr<const Manipulator> manipulator, MapPlan plan, const Bytes& file,
                   std::unique_ptr<const AspectMap::Contents>& map) {
  ByteReader reader(file.data(), file.size());
  std::string problem = find_damage(file, reader);
  if (!problem.empty()) return problem;
  const std::string key =
      map_key(*manipulator, plan.space->region(), plan.resolution, plan.depth, plan.deepest_level) +
      coverage_key(plan.slice, plan.modes);
  problem = find_other_key(reader.take_text(), key);
  if (!problem.empty()) return problem;
  const bool complete = plan.complete;
  map = read_record(std::move(manipulator), std::move(plan), reader);
  if (!map || !reader.ok() || reader.left() != checksum_size) return "its contents contradict themselves";
  const bool is_enough = !complete || map->complete || map->indeterminate_leaves == 0;
  return is_enough ? ""
                   : "it was computed without the option `complete`, and leaves open how many aspects there "
                     "are at most";
}

MapResult refused(const std::string& what, const std::string& why) {
  return {MapStatus::refused, what + " not used, since " + why + "; compute the map and save it again.",
          nullptr};
}

std::string named(const std::string& path) { return "Map file '" + path + "' is"; }

/// The map in the bytes that `read` gives; `what` names them in messages.
template <class Read>
MapResult loaded(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                 const std::string& what, const Read& read) try {
  MapPlan plan;
  const std::string bad_options = make_map_plan(*manipulator, options, plan);
  if (!bad_options.empty()) return {MapStatus::refused, bad_options, nullptr};
  Bytes file;
  std::string problem = read(file);
  std::unique_ptr<const AspectMap::Contents> map;
  if (problem.empty()) problem = decode(std::move(manipulator), std::move(plan), file, map);
  if (!problem.empty()) return refused(what, problem);
  return {MapStatus::complete, "", std::make_shared<const AspectMap>(std::move(map))};
} catch (const std::bad_alloc&) {
  return refused(what, "it takes more memory than there is");
}

}  // namespace

std::string problem_of_saving(const std::string& path) {
  if (const std::string why = problem_of_writing(path); !why.empty()) return why;
  std::array<char, magic.size()> start{};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const bool is_map = std::equal(magic.begin(), magic.end(), start.begin(),
                                 [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
  return file.gcount() == 0 || is_map ? "" : "is there and is no map, and would be overwritten";
}

SaveResult save_map(const AspectMap& map, const std::string& path) {
  if (const std::string why = problem_of_saving(path); !why.empty())
    return {false, "Map file '" + path + "' is not saved, since it " + why + "; give another."};
  const std::string problem = replace_file(path, encode(map.contents()));
  if (problem.empty()) return {true, ""};
  return {false, "Map file '" + path + "' is not saved, since " + problem +
                     "; give a file in a folder that exists, can be written to and has room."};
}

MapResult load_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                   const std::string& path) {
  return loaded(std::move(manipulator), options, named(path),
                [&path](Bytes& file) { return read_whole_file(path, largest_file, file); });
}

std::vector<std::uint8_t> map_bytes(const AspectMap& map) { return packed(encode(map.contents())); }

MapResult map_from_bytes(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options,
                         const std::vector<std::uint8_t>& bytes) {
  return loaded(std::move(manipulator), options, "A map that was received is",
                [&bytes](Bytes& file) { return unpack(bytes, file); });
}

MapOptions options_of(const AspectMap& map) {
  const AspectMap::Contents& contents = map.contents();
  MapOptions options;
  options.resolution = contents.resolution;
  options.extra_levels = static_cast<int>(contents.deepest_level - contents.depth);
  options.modes = contents.modes;
  options.slice = contents.slice;
  const std::size_t positions =
      contents.slice ? contents.slice->free_positions() : directions(contents.manipulator->task_space());
  if (positions > 0) {
    options.region = contents.tree.region();
    options.region->dimension = positions;
  }
  return options;
}

}  // namespace parallel_aspects
