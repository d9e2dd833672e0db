#!/usr/bin/python3
"""Waits until a flight through waypoints has come to its end; on a terminal it shows how far the flight is.

It reads the topic waypoint_status. Exits with 1 and one line if there is nothing to read, or the drone comes nowhere.
"""

import signal
import sys
import threading
import time

MASTER_LIMIT_S = 60  # for a ROS master to come up
SILENCE_LIMIT_S = 120  # of the wall's time without a message
STAY_LIMIT_S = 90  # of simulated time without another waypoint


class Flight:
    """What the messages tell of a flight."""

    def __init__(self, clock=time.monotonic):
        self.is_done = False
        self.progress = "waiting for the drone"
        self._clock = clock
        self._heard = clock()
        self._index = None
        self._start_s = self._arrival_s = self._stamp_s = 0.0

    def update(self, stamp_s, index, count, is_done):
        """Takes a message: its stamp [s], the waypoint that is flown to, counted from 0, and all there are."""
        self._heard = self._clock()
        if self._index is None:
            self._start_s = stamp_s
        if index != self._index:
            self._index, self._arrival_s = index, stamp_s
        self._stamp_s = stamp_s
        self.is_done = is_done
        self.progress = f"waypoint {index + 1} of {count}, {stamp_s - self._start_s:.0f} s flown"

    def fault(self):
        """Why it is of no use to wait any longer, or None."""
        if self._clock() - self._heard > SILENCE_LIMIT_S:
            return f"no waypoint_status for {SILENCE_LIMIT_S} s"
        if self._stamp_s - self._arrival_s > STAY_LIMIT_S:
            return f"the drone has come nowhere for {STAY_LIMIT_S} s: {self.progress}"
        return None


def wait_for_master():
    import rosgraph  # pylint: disable=import-outside-toplevel

    deadline = time.monotonic() + MASTER_LIMIT_S
    while not rosgraph.is_master_online():
        if time.monotonic() > deadline:
            sys.exit(f"watch_flight.py: no ROS master for {MASTER_LIMIT_S} s")
        time.sleep(0.2)


def show(flight):
    if sys.stdout.isatty():
        print(f"\rdemo: {flight.progress} ", end="", flush=True)


def main():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ends without a word, even if the shell had it ignored
    wait_for_master()
    import rospy  # pylint: disable=import-outside-toplevel
    from semantic_slam.msg import WaypointStatus  # pylint: disable=import-outside-toplevel

    rospy.init_node("watch_flight", disable_signals=True, disable_rostime=True)
    flight = Flight()
    changed = threading.Event()

    def on_status(msg):
        flight.update(msg.header.stamp.to_sec(), msg.index, msg.count, msg.state == WaypointStatus.STATE_DONE)
        changed.set()

    rospy.Subscriber("waypoint_status", WaypointStatus, on_status, queue_size=10)
    while not flight.is_done:
        changed.wait(0.5)
        changed.clear()
        show(flight)
        if flight.fault():
            sys.exit(f"watch_flight.py: {flight.fault()}")
    if sys.stdout.isatty():
        print()


if __name__ == "__main__":
    main()
