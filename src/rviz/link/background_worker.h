// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_LINK_BACKGROUND_WORKER_H
#define PARALLEL_ASPECTS_RVIZ_LINK_BACKGROUND_WORKER_H

#include <ros/service.h>
#include <ros/service_client.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>

namespace parallel_aspects {

/// A thread for what may take long: calls of the master and of services. Jobs are done one after the other.
class BackgroundWorker {
 public:
  using Job = std::function<void()>;

  BackgroundWorker();
  /// Drops what waits, interrupts a call of a service, and waits for the thread.
  ~BackgroundWorker();
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;

  void post(Job job);         ///< after all others
  void post_urgent(Job job);  ///< before the others that wait

  bool stopping() const;

  /// For jobs: waits, but not longer than until the worker ends. Whether it goes on.
  bool sleep(std::chrono::milliseconds time) const;

  /// For jobs: calls a service of this full name. Empty where it was answered in time; else why not.
  template <typename Service>
  std::string call(const std::string& name, Service& service, std::chrono::milliseconds patience) const;

 private:
  void run();

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool stopping_ = false;
  std::thread thread_;
};

// roscpp waits for an answer without end, unless the connection is dropped, which is done here from outside.
template <typename Service>
std::string BackgroundWorker::call(const std::string& name, Service& service,
                                   std::chrono::milliseconds patience) const {
  if (!ros::service::exists(name, false)) return name + " is not there.";
  ros::ServiceClient client = ros::service::createClient<Service>(name, true);
  if (!client.isValid()) return name + " cannot be reached.";
  auto answer = std::async(std::launch::async, [client, &service]() mutable { return client.call(service); });
  const auto end = std::chrono::steady_clock::now() + patience;
  constexpr std::chrono::milliseconds between_looks(20);
  while (answer.wait_for(between_looks) != std::future_status::ready)
    if (stopping() || std::chrono::steady_clock::now() > end) {
      client.shutdown();
      break;
    }
  if (answer.get()) return {};
  return std::chrono::steady_clock::now() > end ? name + " does not answer." : name + " failed.";
}

/// Whether an aspect_node can be reached, asked once a second in a thread of its own. A node that was killed
/// is still a publisher for the master and for roscpp, which goes on trying to reach it.
class NodePing {
 public:
  /// `node`: its full name.
  explicit NodePing(const std::string& node);

  bool answers() const noexcept { return answers_; }

 private:
  std::atomic<bool> answers_{false};
  BackgroundWorker worker_;  // ends first
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_LINK_BACKGROUND_WORKER_H
