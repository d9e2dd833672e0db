"""track_boxes and evaluate_tracking: as good on MOT15 as the reference implementation of BoT-SORT."""

import json

import pytest

# From the same boxes, without camera-motion compensation and appearance: MOTA, IDF1 in percent.
REFERENCE = {
    "TUD-Campus": (64.9, 72.0),
    "ETH-Sunnyday": (58.2, 76.7),
    "ETH-Pedcross2": (45.6, 55.0),
    "Venice-2": (18.3, 41.8),
}


def test_a_box_that_moves_keeps_its_id(run_program, tmp_path):
    boxes = [f"{frame},-1,{100 + 4 * frame},50,40,80,0.9,-1,-1,-1" for frame in range(1, 21)]
    (tmp_path / "det.txt").write_text("\n".join(boxes) + "\n")
    result = run_program("track_boxes", tmp_path / "det.txt", "--out", tmp_path / "out.txt")
    assert result.returncode == 0, result.stderr
    tracked = [line.split(",") for line in (tmp_path / "out.txt").read_text().splitlines()]
    assert [int(row[0]) for row in tracked] == list(range(1, 21))
    assert {row[1] for row in tracked} == {"1"}


def test_nothing_found_is_nothing_tracked(run_program, tmp_path):
    (tmp_path / "det.txt").write_text("")
    result = run_program("track_boxes", tmp_path / "det.txt", "--out", tmp_path / "out.txt")
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "out.txt").read_text() == ""


@pytest.mark.parametrize("name", REFERENCE)
def test_is_as_good_as_the_reference(run_program, shared_data, tmp_path, name):
    sequence = shared_data(f"data/mot15/{name}")
    out, again = tmp_path / "out.txt", tmp_path / "again.txt"
    for path in (out, again):
        result = run_program("track_boxes", sequence / "det/det.txt", "--out", path)
        assert result.returncode == 0, result.stderr
    assert out.read_bytes() == again.read_bytes()
    score = run_program("evaluate_tracking", sequence / "gt/gt.txt", out, "--json")
    assert score.returncode == 0, score.stderr
    score = json.loads(score.stdout)
    mota, idf1 = REFERENCE[name]
    # The reference measures boxes as a pixel wider and higher, which turns few pairs in a thousand.
    assert score["mota"] == pytest.approx(mota, abs=0.3)
    assert score["idf1"] == pytest.approx(idf1, abs=1.0)
    assert 0.0 < score["hota"] < 100.0


def test_prints_a_table(run_program, tmp_path):
    boxes = tmp_path / "boxes.txt"
    boxes.write_text("1,1,10,20,30,40,1,-1,-1,-1\n2,1,12,20,30,40,1,-1,-1,-1\n")
    result = run_program("evaluate_tracking", boxes, boxes)
    assert result.returncode == 0, result.stderr
    assert "MOTA             100.0 %" in result.stdout
