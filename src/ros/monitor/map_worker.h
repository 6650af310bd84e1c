// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_MAP_WORKER_H
#define PARALLEL_ASPECTS_ROS_MONITOR_MAP_WORKER_H

#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/manipulator.h"
#include "ros/messages/conversions.h"
#include "ros/monitor/known_domains.h"

#include <parallel_aspects/MapProgress.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace parallel_aspects {

/// What a computation has to do with the map file.
enum class FileUse {
  none,  ///< for options that are not those of the node
  save,  ///< writes the new map to it
  load,  ///< takes the map from it if it is the one wanted; computes and writes it otherwise
};

/// What is in use: a map, or with six degrees of freedom a roadmap; neither until the first is complete.
struct KnownAspects {
  std::shared_ptr<const AspectMap> map;
  std::shared_ptr<const PoseRoadmap> roadmap;
  std::shared_ptr<const DistanceMap> distances;  ///< of the map, some time after it

  /// Lower bound of the number of aspects, proved; 0 while nothing is known.
  std::uint32_t proved_count() const noexcept;

  /// What measures distances of this manipulator; null until it is ready, and where the map is of another, as
  /// where it leaves out limits that distances keep.
  std::shared_ptr<const DistanceMap> distances_of(
      const std::shared_ptr<const Manipulator>& manipulator) const noexcept;
};

/// Computes maps on a thread of its own, one at a time, and keeps the last complete one. With six degrees of
/// freedom it makes a roadmap instead, of which the reports tell; there is no map then.
class MapWorker {
 public:
  /// Called on the worker thread with every report; `map` is set with the one that says COMPLETE, but not
  /// with six degrees of freedom.
  using Listener = std::function<void(const MapProgress&, const std::shared_ptr<const AspectMap>& map)>;
  using Job = std::uint64_t;

  /// Called on the worker thread with the uniqueness domains of a new map, where there are some. It may take
  /// long, unless that turns true.
  using DomainListener =
      std::function<void(const std::shared_ptr<const Uniqueness>&, const std::atomic<bool>& cancelled)>;

  /// `file`: path of the map file; empty for none. `uniqueness`: whether, and how, uniqueness domains are
  /// found when all of that is done.
  MapWorker(std::shared_ptr<const Manipulator> manipulator, std::string file, Listener listener,
            const UniquenessParameters& uniqueness = {}, DomainListener on_domains = {});

  /// Cancels and waits.
  ~MapWorker();

  /// Begins a computation and cancels the one that runs, if any.
  Job compute(const MapOptions& options, FileUse use = FileUse::none);

  /// Cancels this job if it still runs or waits, and what is found in its map after it.
  void cancel(Job job);

  /// The newest report of a job, after waiting for its end, but no longer than `patience`. A job that a newer
  /// one has displaced is CANCELLED.
  MapProgress wait(Job job, std::chrono::milliseconds patience) const;

  MapProgress progress() const;                              ///< newest report of all
  KnownAspects known() const;                                ///< what is in use
  std::shared_ptr<const AspectMap> map() const;              ///< that of `known`
  Status why_no_map() const;                                 ///< NO_MAP, or that there is none yet
  std::string file_message() const;                          ///< what became of the map file
  KnownDomains domains() const { return domains_.known(); }  ///< of the newest map

 private:
  struct Request {
    MapOptions options;
    FileUse use = FileUse::none;
  };

  void run();
  void carry_out(const Request& request);
  void make_map(const Request& request);
  ask::MapQuestion question_of(const Request& request);
  void save(const AspectMap& map);
  void make_distances_ready();
  void say_of_file(const std::string& message, bool well);
  MapProgress dated(MapProgress progress) const;  // with header and proved_count; under the lock
  void report(MapProgress progress, const KnownAspects& found = {});

  const std::shared_ptr<const Manipulator> manipulator_;
  const std::string file_;
  const Listener listener_;
  const DomainListener on_domains_;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::optional<Request> next_;
  Job newest_job_ = 0;   // last one asked for
  Job running_job_ = 0;  // the one that `progress_` is about
  std::atomic<bool> cancelled_{false};
  bool stopping_ = false;
  MapProgress progress_;
  KnownAspects known_;
  std::string file_message_;
  DomainFinder domains_;
  std::thread thread_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_MAP_WORKER_H
