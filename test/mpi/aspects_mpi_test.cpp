// SPDX-License-Identifier: BSD-3-Clause
// Maps by several processes, as a user starts them.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Outcome {
  int code = 0;
  std::string output;
};

Outcome outcome_of(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {-1, ""};
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) outcome.output += static_cast<char>(c);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

class AspectsMpi : public testing::Test {
 protected:
  AspectsMpi() {
    std::string pattern = (fs::temp_directory_path() / "aspects_mpi_XXXXXX").string();
    folder_ = mkdtemp(pattern.data()) == nullptr ? "" : pattern;
    // The tests may run as root in a container, and on fewer cores than processes.
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
    setenv("PARALLEL_ASPECTS_SHARE", PARALLEL_ASPECTS_SOURCE_DIR, 1);
  }
  ~AspectsMpi() override { fs::remove_all(folder_); }

  std::string folder(const std::string& name) const { return folder_ + "/" + name; }

  Outcome run(int processes, const std::string& arguments) const {
    return outcome_of("timeout 300 mpirun -n " + std::to_string(processes) + " " ASPECTS_MPI " " + arguments +
                      " 2>" + folder("messages"));
  }

  std::string messages() const {
    std::ifstream stream(folder("messages"));
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  /// All of the result but what the run took.
  json map_by(int processes, const std::string& arguments) const {
    const Outcome outcome = run(processes, arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << messages();
    json result = json::parse(outcome.output, nullptr, false);
    if (!result.is_object()) return {};
    EXPECT_EQ(result["run"]["processes"], processes);
    result.erase("run");
    return result;
  }

  std::string folder_;
};

const std::string five_bar = "map five_bar --resolution 0.2 --shard-level 2 --folder ";

// Five processes are more than there are modes and signs to put together.
TEST_F(AspectsMpi, AnyNumberOfProcessesGivesOneMap) {
  const json one = map_by(1, five_bar + folder("one"));
  EXPECT_EQ(one["proved_count"], 10);
  for (const int processes : {2, 4, 5})
    EXPECT_EQ(one, map_by(processes, five_bar + folder(std::to_string(processes))));
}

TEST_F(AspectsMpi, TakesUpFinishedShardsAndMendsDamagedOnes) {
  const json whole = map_by(2, five_bar + folder("shards"));
  for (const int shard : {0, 3, 7}) fs::remove(folder("shards") + "/shard_" + std::to_string(shard));
  EXPECT_EQ(whole, map_by(2, five_bar + folder("shards")));
  std::ofstream(folder("shards") + "/shard_5") << "damaged";
  EXPECT_EQ(whole, map_by(2, five_bar + folder("shards")));
  EXPECT_NE(messages().find("shard_5' is not used"), std::string::npos) << messages();
}

TEST_F(AspectsMpi, AFolderOfAnotherMapIsRefusedOnce) {
  map_by(1, five_bar + folder("shards"));
  const Outcome outcome = run(2, "map bipod --folder " + folder("shards"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.output, "");
  const std::string said = messages();
  const std::size_t at = said.find("holds the shards of another map");
  EXPECT_NE(at, std::string::npos) << said;
  EXPECT_EQ(said.find("holds the shards of another map", at + 1), std::string::npos) << said;
}

// Killed once some shards are there.
TEST_F(AspectsMpi, ADeadProcessEndsTheRunAndItsShardsAreTakenUp) {
  const std::string map = "map three_rrr --resolution 1 --folder ";
  std::ofstream(folder("kill.sh")) << "timeout 300 mpirun -n 2 " ASPECTS_MPI " " << map << folder("shards")
                                   << " > /dev/null 2>&1 &\n"
                                   << "for i in $(seq 6000); do [ -e " << folder("shards")
                                   << "/shard_1 ] && break; sleep 0.01; done\n"
                                   << "pkill -9 -n -f '^" ASPECTS_MPI ".*" << folder("shards")
                                   << "'\nwait $!\n";
  EXPECT_NE(outcome_of("bash " + folder("kill.sh")).code, 0);
  EXPECT_TRUE(fs::exists(folder("shards") + "/shard_1"));
  EXPECT_EQ(map_by(2, map + folder("shards")), map_by(1, map + folder("other")));
}

TEST_F(AspectsMpi, BadInputIsOneSentence) {
  EXPECT_EQ(run(2, "map five_bar").code, 2);
  EXPECT_NE(messages().find("--folder"), std::string::npos) << messages();
  EXPECT_EQ(run(2, "map five_bar --resolution -1 --folder " + folder("shards")).code, 1);
  EXPECT_EQ(run(2, "map five_bar --shard-level 9 --resolution 5 --folder " + folder("shards")).code, 1);
  EXPECT_NE(messages().find("finer than the map"), std::string::npos) << messages();
}

TEST_F(AspectsMpi, Helps) {
  const Outcome outcome = run(1, "map --help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.output.find("Usage: aspects_mpi map"), std::string::npos);
}

}  // namespace
}  // namespace parallel_aspects
