// SPDX-License-Identifier: BSD-3-Clause
// Files that are cut, changed, forged or of something else, and files that cannot be written.
#include "aspects/file/map_file_fixture.h"
#include "aspects/map/map_contents.h"

#include <gtest/gtest.h>

#include "support/thoroughness.h"
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <zlib.h>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::leaves;
using test::MapFile;
using test::numbers;
using test::random_pose;
using test::RobotPtr;

void put_u32(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes.at(at + i) = static_cast<char>(value >> 8 * i);
}

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))} << 8 * i;
  return value;
}

// The forger's step: the checksum is right again.
std::string with_checksum(std::string bytes) {
  const std::size_t size = bytes.size() - 4;
  const auto sum = crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), size);
  put_u32(bytes, size, static_cast<std::uint32_t>(sum));
  return bytes;
}

TEST_F(MapFile, TheGraphIsWrittenOnceItIsKnown) {
  const std::string without = saved(*map_);
  EXPECT_FALSE(load(without, five_bar_, options_)->contents().graph);
  compute_aspect_graph(*map_);
  const std::string with = saved(*map_);
  EXPECT_GT(with.size(), without.size());
  EXPECT_TRUE(load(with, five_bar_, options_)->contents().graph);
}

// Of a graph whose gates and sets are not those of the aspects.
TEST_F(MapFile, ForgedGraphsAreRefused) {
  const std::size_t is_known_at = saved(*map_).size() - 5;
  compute_aspect_graph(*map_);
  const std::string bytes = saved(*map_);
  const std::size_t gate_at = is_known_at + 5, kind_at = gate_at + 8, crossings_at = gate_at + 10 + 7 * 8;
  const std::size_t group_at = bytes.size() - 8;  // the last one
  ASSERT_EQ(bytes[is_known_at], 1);
  const auto refuse = [&](std::size_t at, std::uint32_t value) {
    SCOPED_TRACE("byte " + std::to_string(at - is_known_at) + ", value " + std::to_string(value));
    std::string forged = bytes;
    put_u32(forged, at, value);
    expect_refused(with_checksum(forged), "contradict");
  };
  for (const std::uint32_t id : {0U, 11U, 0xffffffffU}) refuse(gate_at, id), refuse(gate_at + 4, id);
  for (const std::uint32_t count : {0U, 1U, 0x7fffffffU}) refuse(is_known_at + 1, count);
  for (const std::uint32_t count : {0U, 7U, 0x7fffffffU}) refuse(crossings_at, count);
  refuse(group_at, 5U);
  for (const int change : {2, 255}) {
    std::string forged = bytes;
    forged[kind_at] = static_cast<char>(change);
    expect_refused(with_checksum(forged), "contradict");
    forged = bytes;
    forged[kind_at + 1] = static_cast<char>(change);  // the leg
    expect_refused(with_checksum(forged), "contradict");
    forged = bytes;
    forged[is_known_at] = static_cast<char>(change);
    expect_refused(with_checksum(forged), "contradict");
  }
}

TEST_F(MapFile, CutFilesAreRefused) {
  const std::string bytes = saved(*map_);
  for (std::size_t part = 0; part < 50; ++part)
    expect_refused(bytes.substr(0, bytes.size() * part / 50), "it is ");
  for (std::size_t size = 0; size < 24; ++size) expect_refused(bytes.substr(0, size), "it is ");
  expect_refused(bytes.substr(0, bytes.size() - 1), "cut off");
  expect_refused(bytes + "x", "too long");
}

TEST_F(MapFile, EveryFlippedBitIsNoticed) {
  const std::string bytes = saved(*map_);
  std::mt19937_64 random(11);
  for (int i = 0; i < test::thinned(500); ++i) {
    const std::size_t at = random() % bytes.size(), bit = random() % 8;
    SCOPED_TRACE("byte " + std::to_string(at) + ", bit " + std::to_string(bit));
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 1 << bit);
    expect_refused(flipped, "since it");
  }
}

constexpr std::size_t version_at = 8, package_at = 20;

TEST_F(MapFile, OtherVersionsAreRefused) {
  const std::string bytes = saved(*map_);
  std::string other = bytes;
  put_u32(other, version_at, u32(other, version_at) + 1);
  expect_refused(with_checksum(other), "its format is version");
  other = bytes;
  other[package_at + 4] = '9';
  expect_refused(with_checksum(other), "it was written by version '9");
}

// A proof that was corrected since: the map is not taken for one.
TEST_F(MapFile, OtherRevisionsOfTheProofsAreRefused) {
  std::string other = saved(*map_);
  const std::size_t revision_at = package_at + 4 + u32(other, package_at);
  put_u32(other, revision_at, u32(other, revision_at) + 1);
  expect_refused(with_checksum(other), "of the proofs and not");
}

TEST_F(MapFile, ForeignFilesAreRefused) {
  expect_refused("", "not a map file");
  expect_refused(std::string(100000, 'A'), "not a map file");
  fs::remove(file_);
  expect_refused(five_bar_, options_, "No such file");
  fs::create_directory(file_);
  expect_refused(five_bar_, options_, "not a regular file");
}

TEST_F(MapFile, OtherRobotsAreRefusedWithWhatDiffers) {
  saved(*map_);
  ManipulatorDescription description{"five_bar", TaskSpace::T2, five_bar_->legs(), "base", {}};
  description.task_frame.setIdentity();
  const auto expect = [&](const std::function<void(std::vector<Leg>&)>& change, const std::string& why) {
    ManipulatorDescription changed = description;
    change(changed.legs);
    expect_refused(std::make_shared<const Manipulator>(changed), options_, why);
  };
  const auto actuation = [](Leg& leg) -> RevoluteActuation& {
    return std::get<RevoluteActuation>(leg.actuation);
  };
  const double tiny = 1e-15;
  expect([&](auto& legs) { actuation(legs[0]).radius += 4.0 * tiny; }, "leg 1, crank length 8");
  expect([&](auto& legs) { legs[1].rod_length += 4.0 * tiny; }, "leg 2, rod length 8");
  expect([&](auto& legs) { actuation(legs[1]).center.y() += tiny; }, "leg 2, center 9");
  expect([&](auto& legs) { legs[0].anchor.z() += tiny; }, "leg 1, anchor");
  expect([&](auto& legs) { legs[1].limits.upper = 100.0; }, "leg 2, limits -inf 100");
  expect([&](auto& legs) { actuation(legs[0]).axis *= -1.0; }, "leg 1, axis");
  expect([&](auto& legs) { actuation(legs[0]).zero_direction = Eigen::Vector3d::UnitY(); },
         "leg 1, zero direction");
  expect_refused(test::bipod(), options_, "\"robot 'five_bar'\" and not \"robot 'bipod'\"");
  EXPECT_EQ(load_map(std::make_shared<const Manipulator>(description), options_, file_).status,
            MapStatus::complete);
}

TEST_F(MapFile, OtherOptionsAreRefusedWithWhatDiffers) {
  saved(*map_);
  expect_refused(five_bar_, coarse(0.3), "\"resolution 0.8");
  MapOptions options = options_;
  options.extra_levels = 3;
  expect_refused(five_bar_, options, "contested leaves halved 3 times");
  options = options_;
  options.region = Box{2, {0.0, 0.0, 0.0}, {5.0, 5.0, 0.0}};
  expect_refused(five_bar_, options, "region along coordinate 1 from 0 to 5");
  options = options_;
  options.threads = 1;
  EXPECT_EQ(load_map(five_bar_, options, file_).status, MapStatus::complete);
  options.resolution = -1.0;
  EXPECT_EQ(load_map(five_bar_, options, file_).status, MapStatus::refused);
}

// Where the record begins: behind the versions, the revision of the proofs and the key.
std::size_t record_at(const std::string& bytes) {
  const std::size_t key_at = package_at + 8 + u32(bytes, package_at);
  return key_at + 4 + u32(bytes, key_at);
}

TEST_F(MapFile, ForgedParentsAreRefused) {
  const std::string bytes = saved(*map_);
  const std::size_t at = record_at(bytes);
  const std::uint32_t parents = u32(bytes, at);
  ASSERT_GT(parents, 10U);
  ASSERT_EQ(u32(bytes, at + 4), 0U);
  // The second parent: one that has children, and some that do not exist yet or never.
  for (const std::uint32_t parent : {0U, 5U, parents * 4U, 0x7fffffffU, 0xffffffffU}) {
    std::string forged = bytes;
    put_u32(forged, at + 8, parent);
    expect_refused(with_checksum(forged), "contradict");
  }
}

TEST_F(MapFile, ForgedCountsAreRefused) {
  const std::string bytes = saved(*map_);
  const std::size_t at = record_at(bytes), states_at = at + 4 + 4 * u32(bytes, at);
  for (const std::size_t count_at : {package_at, at, states_at})
    for (const std::uint32_t count :
         {0U, u32(bytes, count_at) - 1, u32(bytes, count_at) + 1, 0x40000000U, 0xffffffffU}) {
      std::string forged = bytes;
      put_u32(forged, count_at, count);
      expect_refused(with_checksum(forged), "since it");
    }
}

TEST_F(MapFile, ForgedStatesAreRefused) {
  const std::string bytes = saved(*map_);
  const std::size_t at = record_at(bytes), states_at = at + 4 + 4 * u32(bytes, at);
  const std::size_t last_state = states_at + 4 + u32(bytes, states_at) - 1;
  // Divided without children; inherited; pending; inside both signs; and some that there are none of.
  for (const int code : {0x81, 0x82, 0x84, 0x07, 0x04, 0x08, 0xff}) {
    std::string forged = bytes;
    forged[last_state] = static_cast<char>(code);
    expect_refused(with_checksum(forged), "contradict");
  }
}

// Whatever is in the file behind its key: it is refused, or the map answers every question.
TEST_F(MapFile, ForgedFilesDoNoHarm) {
  compute_aspect_graph(*map_);
  const std::string bytes = saved(*map_);
  const std::size_t at = record_at(bytes);
  std::mt19937_64 random(13);
  int refused = 0, taken = 0;
  for (int i = 0; i < test::thinned(1000); ++i) {
    std::string forged = bytes;
    for (std::size_t change = 0; change <= random() % 3; ++change)
      forged[at + random() % (bytes.size() - at - 4)] = static_cast<char>(random());
    const auto map = load(with_checksum(forged), five_bar_, options_);
    ++(map ? taken : refused);
    if (!map) continue;
    leaves(*map);
    if (map->contents().graph) numbers(*map->contents().graph);
    for (int pose = 0; pose < 20; ++pose)
      for (const WorkingMode& mode : map->working_modes()) {
        const Location location = map->locate(random_pose(*map, random), mode);
        EXPECT_LE(location.aspect, static_cast<int>(map->aspects().size()));
      }
  }
  EXPECT_GT(refused, test::thinned(300));
  RecordProperty("taken", taken);
}

// A limit on the size of files stands for a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(MapFile, AFailingSaveLeavesTheOldFile) {
  const std::string before = saved(*map_);
  const auto finer = compute_aspect_map(five_bar_, coarse(0.2)).map;
  SaveResult result;
  {
    const FileSizeLimit limit(before.size());
    result = save_map(*finer, file_);
  }
  EXPECT_FALSE(result.saved);
  EXPECT_NE(result.message.find(file_.string()), std::string::npos) << result.message;
  EXPECT_EQ(contents(file_), before);
  EXPECT_EQ(files_in_folder(), 1U);
  EXPECT_NE(saved(*finer), before);
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(MapFile, FoldersThatCannotBeWrittenToAreReported) {
  const SaveResult missing = save_map(*map_, folder_ / "none" / "map");
  EXPECT_FALSE(missing.saved);
  EXPECT_NE(missing.message.find("in no folder that can be written to"), std::string::npos)
      << missing.message;
  fs::create_directory(file_);
  EXPECT_FALSE(save_map(*map_, file_).saved);
  EXPECT_TRUE(fs::is_directory(file_));
  EXPECT_EQ(files_in_folder(), 1U);
  EXPECT_FALSE(save_map(*map_, "/proc/map").saved);
}

TEST_F(MapFile, WhatIsNoMapIsNotWrittenOver) {
  for (const char* text : {"<robot/>", "x", "ASPECTS of another kind"}) {
    std::ofstream(file_) << text;
    const SaveResult refused = save_map(*map_, file_);
    EXPECT_FALSE(refused.saved);
    EXPECT_NE(refused.message.find("is no map"), std::string::npos) << refused.message;
    EXPECT_EQ(contents(file_), text);
  }
  std::ofstream(file_) << "";
  EXPECT_TRUE(save_map(*map_, file_).saved);
  EXPECT_TRUE(save_map(*map_, file_).saved);
}

TEST_F(MapFile, LinksAreFollowedAndWhatIsNoFileIsNotReplaced) {
  saved(*map_);
  const fs::path link = folder_ / "link", pipe = folder_ / "pipe";
  fs::create_symlink(file_, link);
  ASSERT_TRUE(fs::remove(file_) && std::ofstream(file_));
  EXPECT_TRUE(save_map(*map_, link).saved);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_GT(fs::file_size(file_), 0U);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const SaveResult refused = save_map(*map_, pipe);
  EXPECT_FALSE(refused.saved);
  EXPECT_NE(refused.message.find("not a regular file"), std::string::npos) << refused.message;
  EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace parallel_aspects
