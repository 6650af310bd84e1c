#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sums up what the monitor saw of a recording: how far it is known, the least distances, and what was crossed.

    rosrun parallel_aspects session_summary.py state:=/aspect_node/state transitions:=/aspect_node/transitions &
    rosbag play --clock recording.bag

It prints the summary when no state has come for ~silence [s], or at Ctrl-C.
"""
import math
import threading
import time

import rospy
from parallel_aspects.msg import AspectState, AspectTransition, Status

DISTANCES = ("parallel_distance", "serial_distance", "limit_distance")
LEVELS = {AspectState.CLEAR: "clear", AspectState.WARN: "warn", AspectState.STOP: "stop", AspectState.UNKNOWN: "unknown",
          AspectState.NO_THRESHOLD: "with no threshold"}


class Summary:
    def __init__(self):
        self.lock = threading.Lock()
        self.arrival = None  # of the last state that followed a sample, by the wall clock
        self.stamps = []  # of the first and the last sample
        self.levels = dict.fromkeys(LEVELS.values(), 0)
        self.least = {name: (math.inf, None) for name in DISTANCES}  # [m], and when
        self.first_unknown = None  # stamp, and why
        self.transitions = []
        self.subscribers = [
            rospy.Subscriber("state", AspectState, self.on_state, queue_size=10000),
            rospy.Subscriber("transitions", AspectTransition, self.on_transition, queue_size=10000),
        ]

    def on_state(self, state):
        with self.lock:
            if state.status.code in (Status.NO_JOINT_STATES, Status.STALE):
                return  # of no sample
            stamp = state.header.stamp.to_sec()
            self.arrival = time.monotonic()
            self.stamps = [self.stamps[0] if self.stamps else stamp, stamp]
            self.levels[LEVELS.get(state.level, "unknown")] += 1
            if state.status.code != Status.OK:
                self.first_unknown = self.first_unknown or (stamp, state.status.message)
                return
            for name in DISTANCES:
                self.least[name] = min(self.least[name], (getattr(state, name).lower, stamp), key=lambda each: each[0])

    def on_transition(self, transition):
        with self.lock:
            self.transitions.append((transition.header.stamp.to_sec(), transition.message))

    def has_ended(self, silence):
        with self.lock:
            return self.arrival is not None and time.monotonic() - self.arrival > silence

    def text(self):
        with self.lock:
            if not self.stamps:
                return "No joint sample was followed."
            start = self.stamps[0]
            lines = ["%.3f s, states: %s" % (self.stamps[1] - start, ", ".join("%d %s" % (n, level) for level, n in self.levels.items() if n))]
            if self.first_unknown:
                lines.append("first not known at %.3f s: %s" % (self.first_unknown[0] - start, self.first_unknown[1]))
            for name, (value, stamp) in self.least.items():
                if stamp is not None:
                    lines.append("least %s: %.6g m, proved, at %.3f s" % (name, value, stamp - start))
            lines.append("%d transitions" % len(self.transitions))
            lines += ["  at %.3f s: %s" % (stamp - start, message) for stamp, message in self.transitions]
            return "\n".join(lines)


if __name__ == "__main__":
    rospy.init_node("session_summary")
    summary = Summary()
    longest = rospy.get_param("~silence", 3.0)
    while not rospy.is_shutdown() and not summary.has_ended(longest):
        time.sleep(0.1)  # by the wall clock: simulated time ends with the recording
    print(summary.text(), flush=True)
