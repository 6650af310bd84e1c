// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/shards/shard_folder.h"

#include "aspects/file/map_key.h"
#include "aspects/file/packed_bytes.h"
#include "aspects/file/tree_bytes.h"
#include "aspects/file/whole_file.h"

#include <filesystem>
#include <system_error>

namespace parallel_aspects {
namespace {

constexpr std::size_t largest_key = std::size_t{1} << 24, largest_shard = std::size_t{1} << 32;

Bytes as_bytes(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace

std::string ShardFolder::claim() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (!std::filesystem::is_directory(path_, error))
    return "Folder '" + path_ + "' cannot be made; give one that can be written to.";
  const std::string key_file = path_ + "/map.key";
  Bytes held;
  if (!std::filesystem::exists(key_file, error)) {
    const std::string problem = replace_file(key_file, as_bytes(plan_.key));
    return problem.empty()
               ? ""
               : "File '" + key_file + "' is not written, since " + problem + "; give another folder.";
  }
  const std::string problem = read_whole_file(key_file, largest_key, held);
  const std::string key(held.begin(), held.end());
  if (problem.empty() && key == plan_.key) return "";
  const std::string line = line_missing_in(plan_.key, key);
  return "Folder '" + path_ + "' holds the shards of another map" +
         (line.empty() ? std::string() : ", with \"" + line + "\"") + "; give another folder, or remove it.";
}

std::string ShardFolder::file_of(std::size_t shard) const {
  return path_ + "/shard_" + std::to_string(shard);
}

std::optional<PoseTree> ShardFolder::read(std::size_t shard, std::string& problem) const {
  const std::string path = file_of(shard);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return std::nullopt;
  Bytes file, bytes;
  problem = read_whole_file(path, largest_shard, file);
  if (problem.empty()) problem = unpack(file, bytes);
  std::optional<PoseTree> tree;
  if (problem.empty()) {
    ByteReader reader(bytes.data(), bytes.size());
    const bool is_this = reader.take_text() == plan_.key && reader.take_u64() == shard;
    const TreeRecord record = take_tree(reader);
    if (is_this && reader.ok() && reader.left() == 0)
      tree = PoseTree::from_record(plan_.map.space, plan_.map.modes.size(), record);
    if (!tree) problem = is_this ? "its contents contradict themselves" : "it is of another shard";
  }
  if (!problem.empty())
    problem = "Shard file '" + path + "' is not used, since " + problem + "; it is computed anew.";
  return tree;
}

std::string ShardFolder::write(std::size_t shard, const PoseTree& tree) const {
  ByteWriter writer;
  writer.put_text(plan_.key);
  writer.put_u64(shard);
  put_tree(tree.record(), writer);
  const std::string path = file_of(shard);
  const std::string problem = replace_file(path, packed(writer.bytes()));
  return problem.empty() ? ""
                         : "Shard file '" + path + "' is not written, since " + problem +
                               "; give a folder that can be written to and has room.";
}

}  // namespace parallel_aspects
