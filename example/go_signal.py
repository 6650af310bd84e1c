#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Says on ~go whether the robot may go on: while a state of the monitor that is CLEAR or WARN is not older than ~silence.

Whatever else is the case, it says no: STOP, UNKNOWN, NO_THRESHOLD, no state yet, a monitor that is dead, stopped or too slow. Who
listens to ~go treats its silence in the same way, so that this program may die too. A ROS master that was started anew
does not know it, and rospy does not register again: then it starts itself anew, with the same ~silence.
"""
import math
import os
import sys
import threading
import time

import rosgraph
import rospy
from parallel_aspects.msg import AspectState
from std_msgs.msg import Bool


class GoSignal:
    def __init__(self):
        self.silence = rospy.get_param("~silence", 0.2)  # age at which a state counts no longer [s]
        self.last = AspectState(), -math.inf  # the last state, and when it came [s]
        self.forgotten = threading.Event()  # by the master
        self.go = rospy.Publisher("~go", Bool, queue_size=1)
        self.states = rospy.Subscriber("state", AspectState, self.on_state, queue_size=1, tcp_nodelay=True)
        threading.Thread(target=self.watch_master, daemon=True).start()  # which may keep a call waiting

    def on_state(self, state):
        self.last = state, time.monotonic()

    def watch_master(self):
        while not self.forgotten.wait(1.0):
            try:
                rosgraph.Master(rospy.get_name()).lookupNode(rospy.get_name())
            except rosgraph.MasterException:
                self.forgotten.set()
            except Exception:  # whatever a call comes to where there is none, or one that is about to end
                continue

    def may_go(self):
        state, arrival = self.last
        age = (rospy.Time.now() - state.header.stamp).to_sec()  # a latched state may be old when it comes
        recent = time.monotonic() - arrival <= self.silence and abs(age) <= self.silence
        return recent and state.level in (AspectState.CLEAR, AspectState.WARN)

    def run(self):
        while not rospy.is_shutdown():
            if self.forgotten.is_set():
                self.start_anew()
            self.go.publish(self.may_go())
            time.sleep(self.silence / 10.0)  # by the wall clock, which goes on when simulated time does not

    def start_anew(self):
        words = [word for word in sys.argv if not word.startswith("_silence:=")]
        os.execv(sys.executable, [sys.executable, *words, f"_silence:={self.silence}"])


if __name__ == "__main__":
    rospy.init_node("go_signal")
    GoSignal().run()
