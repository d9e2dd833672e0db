"""scripts/watch_flight.py: what it makes of the messages of a flight."""

from watch_flight import SILENCE_LIMIT_S, STAY_LIMIT_S, Flight


class Clock:
    def __init__(self):
        self.now_s = 1000.0

    def __call__(self):
        return self.now_s


def test_tells_how_far_the_flight_is():
    flight = Flight(Clock())
    assert flight.progress == "waiting for the drone"
    flight.update(50.0, 0, 12, False)
    flight.update(57.5, 2, 12, False)
    assert flight.progress == "waypoint 3 of 12, 8 s flown"
    assert not flight.is_done
    flight.update(99.0, 11, 12, True)
    assert flight.is_done


def test_silence_is_a_fault():
    clock = Clock()
    flight = Flight(clock)
    clock.now_s += SILENCE_LIMIT_S - 1
    assert flight.fault() is None
    flight.update(1.0, 0, 2, False)
    clock.now_s += SILENCE_LIMIT_S - 1
    assert flight.fault() is None
    clock.now_s += 2
    assert "no waypoint_status" in flight.fault()


def test_a_drone_that_comes_nowhere_is_a_fault():
    flight = Flight(Clock())
    flight.update(0.0, 0, 3, False)
    flight.update(STAY_LIMIT_S - 1, 0, 3, False)
    assert flight.fault() is None
    flight.update(STAY_LIMIT_S, 1, 3, False)  # it has come somewhere
    flight.update(2 * STAY_LIMIT_S, 1, 3, False)
    assert flight.fault() is None
    flight.update(2 * STAY_LIMIT_S + 1, 1, 3, False)
    assert "waypoint 2 of 3" in flight.fault()
