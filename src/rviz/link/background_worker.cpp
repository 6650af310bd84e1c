// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/link/background_worker.h"

#include <utility>

namespace parallel_aspects {

BackgroundWorker::BackgroundWorker() : thread_([this] { run(); }) {}

BackgroundWorker::~BackgroundWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWorker::post(Job job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  jobs_.push_back(std::move(job));
  changed_.notify_all();
}

void BackgroundWorker::post_urgent(Job job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  jobs_.push_front(std::move(job));
  changed_.notify_all();
}

bool BackgroundWorker::stopping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

bool BackgroundWorker::sleep(std::chrono::milliseconds time) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, time, [this] { return stopping_; });
}

void BackgroundWorker::run() {
  for (;;) {
    Job job;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
      if (stopping_) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
}

namespace {

constexpr std::chrono::milliseconds between_pings(1000);

}  // namespace

NodePing::NodePing(const std::string& node) {
  worker_.post([this, service = node + "/list_aspects"] {
    do answers_ = ros::service::exists(service, false);
    while (worker_.sleep(between_pings));
  });
}

}  // namespace parallel_aspects
