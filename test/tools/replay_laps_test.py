"""replay_laps: a line per lap, and a map that ceases to grow where the place is known."""

import pytest


def rows(stdout):
    header, _, *lines = stdout.splitlines()
    names = [cell.strip() for cell in header.strip("|").split("|")]
    return [dict(zip(names, (float(cell) for cell in line.strip("|").split("|")))) for line in lines]


def test_the_known_room_makes_the_map_grow_less(run_program, room):
    result = run_program("replay_laps", "--config", room.config, "--laps", "3", room.folder)
    assert result.returncode == 0, result.stderr
    laps = rows(result.stdout)
    assert [lap["lap"] for lap in laps] == [1, 2, 3]
    for lap in laps:
        assert lap["images"] == 120
        assert lap["lost"] <= 5  # the four seconds do not end where they begin
        assert 0 < lap["per image, median [ms]"] <= lap["95 % [ms]"]
        assert 10 < lap["memory [MB]"] < 1000
    first, second, third = (lap["keyframes"] for lap in laps)
    assert 1 < first and third - second <= second - first <= first


@pytest.mark.parametrize("arguments, words", [
    (("/nonexistent",), "/nonexistent"),
    (("--laps", "0", "{room}"), "--laps = 0"),
    ((), "SEQUENCE"),
])
def test_refuses_in_one_line(run_program, room, arguments, words):
    given = [argument.format(room=room.folder) for argument in arguments]
    result = run_program("replay_laps", "--config", room.config, *given)
    assert result.returncode == 1
    line, = result.stderr.splitlines()
    assert line.startswith("replay_laps: ") and words in line
