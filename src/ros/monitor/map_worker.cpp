// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/map_worker.h"

#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "ros/messages/conversions.h"

#include <ros/console.h>
#include <ros/time.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace parallel_aspects {
namespace {

// Nothing is known yet.
MapProgress empty_report() {
  MapProgress report;
  report.count_at_most = -1;
  return report;
}

MapProgress computing(const char* what, double share, double resolution) {
  MapProgress report = empty_report();
  report.state = MapProgress::COMPUTING;
  report.progress = share;
  report.resolution = resolution;
  report.message = std::string("The ") + what + " is being computed, " +
                   std::to_string(std::lround(100.0 * share)) + " %.";
  return report;
}

std::string complete_message(const ask::MapAnswer& answer) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g s", answer.seconds);
  const bool is_exact = answer.count_at_most == answer.proved_count;
  return "The map is complete. Aspects found: " + std::to_string(answer.aspects.size()) +
         ", proved: " + (is_exact ? "exactly " : "at least ") + std::to_string(answer.proved_count) +
         (!answer.count_at_most || is_exact ? "" : " and at most " + std::to_string(*answer.count_at_most)) +
         (answer.cut_by_region ? ", in the region" : "") +
         "; pairs unresolved: " + std::to_string(answer.unresolved.size()) + "; time: " + seconds + "." +
         (answer.no_aspect.empty() ? "" : " " + answer.no_aspect);
}

std::string complete_message(const PoseRoadmap& roadmap) {
  return "With six degrees of freedom there is a certified roadmap in place of a map. Poses sampled: " +
         std::to_string(roadmap.poses().size()) + ", aspects proved: at least " +
         std::to_string(roadmap.proved_count()) + ", those that the samples lie in: at most " +
         std::to_string(roadmap.component_count()) + ".";
}

MapProgress ended(MapStatus status, const std::string& message) {
  MapProgress report = empty_report();
  report.message = message;
  report.state = status == MapStatus::complete    ? MapProgress::COMPLETE
                 : status == MapStatus::cancelled ? MapProgress::CANCELLED
                                                  : MapProgress::REFUSED;
  if (status == MapStatus::complete) report.progress = 1.0;
  return report;
}

MapProgress ended(const ask::Outcome<ask::MapAnswer>& outcome) {
  if (outcome.status == MapStatus::cancelled) return ended(outcome.status, "The computation was cancelled.");
  if (!outcome) return ended(outcome.status, text_of(outcome.problems.front(), ask::plain_name));
  const ask::MapAnswer& answer = outcome.answer;
  if (answer.sampled) {
    MapProgress report = ended(outcome.status, complete_message(*answer.sampled->roadmap));
    report.seconds = answer.sampled->roadmap->seconds();
    return report;
  }
  MapProgress report = ended(outcome.status, complete_message(answer));
  report.resolution = answer.resolution;
  report.aspects = static_cast<std::uint32_t>(answer.aspects.size());
  report.count_at_most = count_at_most(*answer.map);
  report.unresolved = static_cast<std::uint32_t>(answer.unresolved.size());
  report.seconds = answer.seconds;
  return report;
}

// What the computation took, besides what is kept, goes back to the system now: else it would stay with the
// process, as much as the finest map ever tried took.
void return_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace

std::shared_ptr<const DistanceMap> KnownAspects::distances_of(
    const std::shared_ptr<const Manipulator>& manipulator) const noexcept {
  return distances && distances->map()->manipulator() == manipulator ? distances : nullptr;
}

std::uint32_t KnownAspects::proved_count() const noexcept {
  const std::size_t count = map ? map->proved_count() : roadmap ? roadmap->proved_count() : 0;
  return static_cast<std::uint32_t>(count);
}

MapWorker::MapWorker(std::shared_ptr<const Manipulator> manipulator, std::string file, Listener listener,
                     const UniquenessParameters& uniqueness, DomainListener on_domains)
    : manipulator_(std::move(manipulator)),
      file_(std::move(file)),
      listener_(std::move(listener)),
      on_domains_(std::move(on_domains)),
      progress_(empty_report()),
      file_message_(file_.empty() ? "none; see map/file" : "not read yet"),
      domains_(*manipulator_, uniqueness),
      thread_([this] { run(); }) {}

MapWorker::~MapWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    cancelled_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

MapWorker::Job MapWorker::compute(const MapOptions& options, FileUse use) {
  const std::lock_guard<std::mutex> lock(mutex_);
  next_ = Request{options, file_.empty() ? FileUse::none : use};
  cancelled_ = true;
  changed_.notify_all();
  return ++newest_job_;
}

void MapWorker::cancel(Job job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (job != newest_job_) return;
  cancelled_ = true;
  if (!next_) return;
  next_.reset();
  running_job_ = job;
  progress_ = dated(empty_report());
  progress_.state = MapProgress::CANCELLED;
  progress_.message = "The computation was cancelled before it began.";
  changed_.notify_all();
}

MapProgress MapWorker::wait(Job job, std::chrono::milliseconds patience) const {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto over = [&] {
    return job != newest_job_ || (running_job_ == job && progress_.state != MapProgress::COMPUTING);
  };
  changed_.wait_for(lock, patience, over);
  if (job == running_job_) return progress_;
  MapProgress report = dated(empty_report());
  report.state = job == newest_job_ ? MapProgress::COMPUTING : MapProgress::CANCELLED;
  report.message =
      job == newest_job_ ? "The computation is about to begin." : "A newer request took its place.";
  return report;
}

MapProgress MapWorker::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

KnownAspects MapWorker::known() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return known_;
}

std::shared_ptr<const AspectMap> MapWorker::map() const { return known().map; }

Status MapWorker::why_no_map() const {
  const std::string message = progress().message;
  const TaskSpace space = manipulator_->task_space();
  if (!has_map(space))
    return make_status(Status::NO_MAP, "No map exists in " + std::string(name(space)) +
                                           ", so aspects have no ids. " + message);
  return make_status(Status::MAP_NOT_READY, "There is no map yet. " + message);
}

std::string MapWorker::file_message() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return file_message_;
}

void MapWorker::run() {
  while (true) {
    Request request;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [&] { return stopping_ || next_.has_value(); });
      if (stopping_) return;
      request = *std::exchange(next_, std::nullopt);
      running_job_ = newest_job_;
      progress_ = dated(empty_report());  // COMPUTING; the report of the job before is over
      cancelled_ = false;
    }
    try {
      carry_out(request);
    } catch (const std::exception& failure) {  // as when there is not enough memory
      report(ended(MapStatus::refused, std::string("The computation ended early: ") + failure.what() + "."));
    }
    return_memory();
  }
}

void MapWorker::carry_out(const Request& request) {
  const std::shared_ptr<const AspectMap> before = map();
  make_map(request);
  if (map() == before) return;
  domains_.find(map(), cancelled_);
  const std::shared_ptr<const Uniqueness> found = domains_.known().uniqueness;
  if (!on_domains_ || !found) return;
  try {
    on_domains_(found, cancelled_);
  } catch (const std::exception& failure) {  // which says nothing of the map
    ROS_WARN_STREAM("Uniqueness domains: what follows on them ended early: " << failure.what() << ".");
  }
}

ask::MapQuestion MapWorker::question_of(const Request& request) {
  ask::MapQuestion question;
  question.complete = request.options.complete;
  question.no_symmetry = !request.options.use_symmetry;
  if (!has_map(manipulator_->task_space())) {
    if (!file_.empty()) say_of_file("not used: with six degrees of freedom there is no map", false);
  } else if (request.use == FileUse::load) {
    std::error_code failure;
    if (std::filesystem::exists(file_, failure) || failure)
      question.source.load = file_;
    else
      say_of_file(file_ + " is not there yet; the map is computed and saved to it", true);
  }
  return question;
}

void MapWorker::make_map(const Request& request) {
  const bool of_map = has_map(manipulator_->task_space());
  const char* const what = of_map ? "map" : "roadmap";
  const double resolution =
      of_map ? request.options.resolution.value_or(default_resolution(*manipulator_)) : 0.0;
  report(computing(what, 0.0, resolution));
  double reported = 0.0;
  ask::Control control;
  control.cancelled = &cancelled_;
  control.progress = [&](const char* /*step*/, double share) {
    if (share < reported + 0.01) return;
    reported = share;
    report(computing(what, share, resolution));
  };
  control.note = [this](const std::string& why) {
    say_of_file("the map is computed, as the file was not used: " + why, false);
  };
  ask::Session session(manipulator_, request.options);
  const auto outcome = ask::answer(session, question_of(request), control);
  const ask::MapAnswer& answer = outcome.answer;
  if (answer.loaded) say_of_file("loaded from " + file_, true);
  report(ended(outcome), {answer.map, answer.sampled ? answer.sampled->roadmap : nullptr, nullptr});
  make_distances_ready();
  if (!outcome || !answer.map || answer.loaded || request.use == FileUse::none) return;
  compute_aspect_graph(*answer.map, {{}, &cancelled_});  // the file holds it, too, unless this is cancelled
  save(*answer.map);
}

// Until then, and where this is cancelled, distances are measured without the map.
void MapWorker::make_distances_ready() {
  const std::shared_ptr<const AspectMap> newest = map();
  if (!newest || cancelled_) return;
  MapControl control;
  control.cancelled = &cancelled_;
  auto ready = std::make_shared<const DistanceMap>(newest, control);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!cancelled_ && known_.map == newest) known_.distances = std::move(ready);
}

void MapWorker::save(const AspectMap& map) {
  const SaveResult result = save_map(map, file_);
  say_of_file(result.saved ? "saved to " + file_ : "the map was not saved: " + result.message, result.saved);
}

void MapWorker::say_of_file(const std::string& message, bool well) {
  if (well)
    ROS_INFO_STREAM("Map file: " << message);
  else
    ROS_WARN_STREAM("Map file: " << message);
  const std::lock_guard<std::mutex> lock(mutex_);
  file_message_ = message;
}

MapProgress MapWorker::dated(MapProgress progress) const {
  progress.header.stamp = ros::Time::now();
  progress.header.frame_id = manipulator_->base_frame();
  progress.proved_count = known_.proved_count();
  return progress;
}

// What was found is in use everywhere before it is announced as complete.
void MapWorker::report(MapProgress progress, const KnownAspects& found) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (found.map || found.roadmap) known_ = found;
    progress = dated(std::move(progress));
  }
  listener_(progress, found.map);
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = std::move(progress);
  changed_.notify_all();
}

}  // namespace parallel_aspects
