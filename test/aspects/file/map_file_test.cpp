// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/map_file.h"

#include "model/coefficients.h"

#include <gtest/gtest.h>

#include "support/robots.h"
#include "support/shipped.h"
#include "support/thoroughness.h"
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <tuple>
#include <vector>
#include <zlib.h>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;
using RobotPtr = std::shared_ptr<const Manipulator>;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

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

Pose random_pose(const AspectMap& map, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const TaskSpace space = map.manipulator()->task_space();
  const Box region = map.region();
  Pose pose;
  if (space == TaskSpace::SO3) {
    pose.orientation =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    return pose;
  }
  PoseCoordinates coordinates(region.dimension);
  for (std::size_t i = 0; i < region.dimension; ++i)
    coordinates[static_cast<Eigen::Index>(i)] =
        std::uniform_real_distribution<double>(region.lower[i], region.upper[i])(random);
  return *pose_from_coordinates(space, coordinates);
}

auto numbers(const Box& box) { return std::make_tuple(box.dimension, box.lower, box.upper); }

auto numbers(const Aspect& aspect) {
  return std::make_tuple(aspect.id, aspect.mode.index(), aspect.determinant_sign, aspect.measure,
                         aspect.measure_lower, aspect.measure_upper, aspect.inside_leaves,
                         numbers(aspect.bounds), aspect.deepest_clearance, aspect.unresolved_with);
}

using Numbers = std::vector<double>;

void append(Numbers& list, const Box& box) {
  list.insert(list.end(), box.lower.begin(), box.lower.end());
  list.insert(list.end(), box.upper.begin(), box.upper.end());
}

// Everything that the leaves of a map tell, in the order told.
Numbers leaves(const AspectMap& map) {
  Numbers list;
  for (const Aspect& aspect : map.aspects()) {
    map.visit_inside_leaves(aspect.id, [&list](const Box& box) { append(list, box); });
    map.visit_inside_poses(aspect.id, [&list](const Pose& pose, double measure) {
      list.insert(list.end(), {pose.position.x(), pose.position.y(), pose.position.z(), measure});
      for (const double each : coefficients_of(pose.orientation.coeffs())) list.push_back(each);
    });
  }
  for (const WorkingMode& mode : map.working_modes())
    map.visit_undecided_leaves(mode, [&list](const Box& box) { append(list, box); });
  return list;
}

void expect_equal(const AspectMap& one, const AspectMap& other) {
  EXPECT_EQ(one.working_modes(), other.working_modes());
  EXPECT_EQ(numbers(one.region()), numbers(other.region()));
  EXPECT_EQ(std::make_tuple(one.resolution(), one.proved_count(), one.unresolved(), one.measure_undecided(),
                            one.seconds()),
            std::make_tuple(other.resolution(), other.proved_count(), other.unresolved(),
                            other.measure_undecided(), other.seconds()));
  ASSERT_EQ(one.aspects().size(), other.aspects().size());
  for (std::size_t i = 0; i < one.aspects().size(); ++i) {
    const Aspect &a = one.aspects()[i], &b = other.aspects()[i];
    EXPECT_EQ(numbers(a), numbers(b)) << "aspect " << i + 1;
    EXPECT_EQ(a.deepest.position, b.deepest.position);
    EXPECT_EQ(a.deepest.orientation.coeffs(), b.deepest.orientation.coeffs());
  }
  EXPECT_TRUE(leaves(one) == leaves(other));
}

// The number of poses that are inside an aspect.
int expect_equal_locations(const AspectMap& one, const AspectMap& other, int count) {
  std::mt19937_64 random(7);
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    const Pose pose = random_pose(one, random);
    for (const WorkingMode& mode : one.working_modes()) {
      const Location a = one.locate(pose, mode), b = other.locate(pose, mode);
      EXPECT_EQ(std::make_tuple(a.status, a.aspect), std::make_tuple(b.status, b.aspect))
          << to_string(one.manipulator()->task_space(), pose) << " in mode " << to_string(mode);
      if (a.status == LocationStatus::inside) ++inside;
    }
  }
  return inside;
}

// A folder of its own, gone at the end of the test.
class MapFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "map_file_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    file_ = folder_ / "map";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string saved(const AspectMap& map) const {
    const SaveResult result = save_map(map, file_);
    EXPECT_TRUE(result.saved) << result.message;
    return contents(file_);
  }

  std::shared_ptr<const AspectMap> load(const std::string& bytes, const RobotPtr& robot,
                                        const MapOptions& options = {}) const {
    write(file_, bytes);
    return load_map(robot, options, file_).map;
  }

  void expect_refused(const std::string& bytes, const std::string& why) const {
    write(file_, bytes);
    expect_refused(five_bar_, options_, why);
  }

  void expect_refused(const RobotPtr& robot, const MapOptions& options, const std::string& why) const {
    const MapResult result = load_map(robot, options, file_);
    EXPECT_EQ(result.status, MapStatus::refused);
    EXPECT_EQ(result.map, nullptr);
    EXPECT_NE(result.message.find(file_.string()), std::string::npos) << result.message;
    EXPECT_NE(result.message.find(why), std::string::npos) << result.message;
    EXPECT_EQ(result.message.back(), '.');
  }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  static MapOptions coarse(double resolution) {
    MapOptions options;
    options.resolution = resolution;
    return options;
  }

  fs::path folder_, file_;
  RobotPtr five_bar_ = test::five_bar();
  MapOptions options_ = coarse(1.0);
  std::shared_ptr<const AspectMap> map_ = compute_aspect_map(five_bar_, options_).map;
};

struct Case {
  const char* name;
  std::function<RobotPtr()> make;
  double resolution;
};

RobotPtr slider() {
  Leg leg = test::planar_revolute_leg(0, {0.0, 0.0}, 1.0, 3.0);
  return test::manipulator("slider", TaskSpace::T1, {leg});
}

class RoundTrip : public MapFile, public testing::WithParamInterface<Case> {};

TEST_P(RoundTrip, EveryAnswerIsTheSame) {
  const RobotPtr robot = GetParam().make();
  MapOptions options = coarse(GetParam().resolution);
  options.modes = working_modes(*robot);
  if (test::is_sanitized && options.modes.size() > 2) options.modes.resize(2);
  options.extra_levels = 3;
  const MapResult computed = compute_aspect_map(robot, options);
  ASSERT_EQ(computed.status, MapStatus::complete) << computed.message;
  ASSERT_FALSE(computed.map->aspects().empty());
  const std::string bytes = saved(*computed.map);
  const MapResult loaded = load_map(robot, options, file_);
  ASSERT_EQ(loaded.status, MapStatus::complete) << loaded.message;
  EXPECT_EQ(loaded.map->manipulator(), robot);
  expect_equal(*computed.map, *loaded.map);
  EXPECT_GT(expect_equal_locations(*computed.map, *loaded.map, test::thinned(1000)), test::thinned(100));
  EXPECT_EQ(saved(*loaded.map), bytes);
}

INSTANTIATE_TEST_SUITE_P(TaskSpaces, RoundTrip,
                         testing::Values(Case{"T1", slider, 0.01}, Case{"T2", test::five_bar, 0.2},
                                         Case{"T2_struts", test::bipod, 0.1},
                                         Case{"SE2", test::three_rrr, 2.0},
                                         Case{"SE2_struts", test::three_rpr, 5.0},
                                         Case{"T3", test::delta, 0.2}, Case{"SO3", test::agile_eye, 0.4}),
                         [](const auto& each) { return each.param.name; });

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
  EXPECT_NE(missing.message.find("No such file or directory"), std::string::npos) << missing.message;
  fs::create_directory(file_);
  EXPECT_FALSE(save_map(*map_, file_).saved);
  EXPECT_TRUE(fs::is_directory(file_));
  EXPECT_EQ(files_in_folder(), 1U);
  EXPECT_FALSE(save_map(*map_, "/proc/map").saved);
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

// A display knows a map by its bytes alone, and not the options that it was computed with.
TEST(MapBytes, AreReadWithTheOptionsThatTheMapTells) {
  for (const char* const robot :
       {"five_bar", "bipod", "three_rrr", "linear_delta", "delta", "spherical_3rrr"}) {
    const RobotPtr manipulator = test::shipped(robot)->mapped_manipulator();
    MapOptions options;
    options.modes = {working_modes(*manipulator).front()};
    options.extra_levels = 2;
    const double size = manipulator->task_space() == TaskSpace::SO3 ? 4.0 : manipulator->size();
    options.resolution = size / 9.7;
    const auto map = compute_aspect_map(manipulator, options).map;
    ASSERT_TRUE(map) << robot;
    const std::vector<std::uint8_t> bytes = map_bytes(*map);
    const MapResult read = map_from_bytes(manipulator, options_of(*map), bytes);
    ASSERT_TRUE(read.map) << robot << ": " << read.message;
    expect_equal(*read.map, *map);
    EXPECT_EQ(map_bytes(*read.map), bytes) << robot;
  }
}

TEST(MapBytes, ThatAreCutOffAreRefused) {
  const RobotPtr manipulator = test::shipped("five_bar")->mapped_manipulator();
  MapOptions options;
  options.resolution = 1.0;
  const std::vector<std::uint8_t> bytes = map_bytes(*compute_aspect_map(manipulator, options).map);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{19}, bytes.size() - 1}) {
    const MapResult read = map_from_bytes(manipulator, options,
                                          {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_FALSE(read.map) << size;
    EXPECT_NE(read.message.find("not used, since"), std::string::npos) << read.message;
  }
}

}  // namespace
}  // namespace parallel_aspects
