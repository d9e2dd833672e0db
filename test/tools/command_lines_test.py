"""Every program: --help, and one clear line and exit code 1 for what it cannot do."""

import pathlib
import subprocess

import pytest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "src/tools"
PROGRAMS = sorted(path.stem for path in TOOLS.glob("*.cpp") if not path.with_suffix(".h").exists())
PROGRAMS += ["render_textured_room", "semantic_octree_benchmark"]

# What is given, and words that the one line must contain. {tmp} is a folder with the files below.
REFUSED = [
    ("replay", "", "--dataset"),
    ("replay", "--dataset {room} --config {config}", "--out"),
    ("replay", "--dataset {tmp}/missing --config {config} --out {tmp}/out", "no such file {tmp}/missing"),
    ("replay", "--dataset {tmp}/text.bag --config {config} --out {tmp}/out", "{tmp}/text.bag"),
    ("replay", "--dataset {tmp}/empty --config {config} --out {tmp}/out", "{tmp}/empty rgb.txt"),
    ("replay", "--dataset {room} --config {tmp}/missing.yaml --out {tmp}/out", "{tmp}/missing.yaml"),
    ("replay", "--dataset {room} --config {tmp}/unknown_key.yaml --out {tmp}/out", "{tmp}/unknown_key.yaml focal"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/text.bag/out", "{tmp}/text.bag"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --stages tracking,semantic", "'semantic' --segmentation"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --stages tracking,objects", "'objects' --detection"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --stages grid", "--stages tracking"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --grid-period -1", "--grid-period"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --labels {tmp}/missing.yaml", "{tmp}/missing.yaml"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --segmentation {tmp}/missing.yaml",
     "{tmp}/missing.yaml"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --stages tracking,cooking", "'cooking'"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --segmentation truth", "{room} labels.txt"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --detection truth", "{room} boxes"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --speed 2", "--speed"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --localization-only", "--localization-only --load-map"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --localization-only --load-map {tmp}/text.bag "
     "--save-map {tmp}/out.map", "--save-map --localization-only"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --load-map {tmp}/missing.map", "{tmp}/missing.map"),
    ("replay", "--dataset {room} --config {config} --out {tmp}/out --load-map {tmp}/text.bag",
     "{tmp}/text.bag no localization map"),
    ("replay_laps", "--config {config}", "SEQUENCE"),
    ("replay_laps", "{room}", "--config"),
    ("replay_laps", "--config {tmp}/missing.yaml {room}", "{tmp}/missing.yaml"),
    ("replay_laps", "--config {config} {tmp}/missing", "{tmp}/missing"),
    ("replay_laps", "--config {config} --laps 0 {room}", "--laps = 0"),
    ("render_sequence", "", "WORLD"),
    ("render_sequence", "{world}", "TRAJECTORY"),
    ("render_sequence", "{tmp}/missing.yaml {tmp}/empty.txt {tmp}/out", "{tmp}/missing.yaml"),
    ("render_sequence", "{world} {tmp}/missing.yaml {tmp}/out", "{tmp}/missing.yaml"),
    ("render_sequence", "{world} {tmp}/empty.txt {tmp}/out", "{tmp}/empty.txt pose"),
    ("render_sequence", "{world} {tmp}/empty.txt {tmp}/out --truth-period 0", "--truth-period"),
    ("render_training_set", "", "OUT"),
    ("render_training_set", "{tmp}/out --split test", "'test' training"),
    ("render_training_set", "{tmp}/out --size 480", "--size '480'"),
    ("render_training_set", "{tmp}/out --worlds 0", "--worlds"),
    ("render_training_set", "{tmp}/text.bag/out", "{tmp}/text.bag"),
    ("draw_world", "", "WORLD"),
    ("draw_world", "{world} home", "OUT"),
    ("draw_world", "{world} home {tmp}/out.txt", ".png"),
    ("draw_world", "{tmp}/missing.yaml home {tmp}/out.png", "{tmp}/missing.yaml"),
    ("draw_world", "{world} {tmp}/missing.yaml {tmp}/out.png", "{tmp}/missing.yaml"),
    ("draw_world", "{world} home {tmp}/out.png --views 0", "--views"),
    ("evaluate_maps", "", "WORLD"),
    ("evaluate_maps", "{world}", "OUT"),
    ("evaluate_maps", "{world} {tmp}/missing", "no such folder {tmp}/missing"),
    ("evaluate_maps", "{world} {tmp}/empty", "{tmp}/empty/trajectory.txt"),
    ("evaluate_maps", "{tmp}/missing.yaml {tmp}/empty", "{tmp}/missing.yaml"),
    ("carmen_replay", "", "LOG"),
    ("carmen_replay", "{tmp}/empty.txt", "--out"),
    ("carmen_replay", "{tmp}/missing.log --out {tmp}/out", "{tmp}/missing.log"),
    ("carmen_replay", "{tmp}/text.bag --out {tmp}/out", "{tmp}/text.bag FLASER"),
    ("carmen_replay", "{tmp}/empty.txt --out {tmp}/out --max-range 0", "--max-range"),
    ("evaluate_trajectory", "", "REFERENCE"),
    ("evaluate_trajectory", "{room}/groundtruth.txt", "ESTIMATE"),
    ("evaluate_trajectory", "{room}/groundtruth.txt {tmp}/missing.txt", "{tmp}/missing.txt"),
    ("evaluate_trajectory", "{room}/groundtruth.txt {tmp}/bad_trajectory.txt", "{tmp}/bad_trajectory.txt 2"),
    ("evaluate_trajectory", "{room}/groundtruth.txt {tmp}/empty.txt", "{tmp}/empty.txt pose"),
    ("evaluate_trajectory", "{room}/groundtruth.txt {room}/groundtruth.txt --max-dt -1", "--max-dt"),
    ("evaluate_trajectory", "{room}/groundtruth.txt {room}/groundtruth.txt --rpe-seconds 1 --rpe-metres 1",
     "--rpe-seconds --rpe-metres"),
    ("evaluate_segmentation", "--card {segmenter}", "SET"),
    ("evaluate_segmentation", "{tmp}/empty", "--card"),
    ("evaluate_segmentation", "--card {tmp}/missing.yaml {tmp}/empty", "{tmp}/missing.yaml"),
    ("evaluate_segmentation", "--card {detector} {photos}", "segmentation"),
    ("evaluate_segmentation", "--card {segmenter} {tmp}/missing", "no such folder {tmp}/missing"),
    ("evaluate_segmentation", "--card {segmenter} {tmp}/empty", "{tmp}/empty labels"),
    ("evaluate_segmentation", "--card {segmenter} {room}", "{room}/labels.txt"),
    ("evaluate_segmentation", "--card {segmenter} {photos} --output {tmp}/out", "{tmp}/photos/images/a.png image"),
    ("evaluate_segmentation", "--card {segmenter} {photos} --classes {tmp}/unknown_key.yaml", "{tmp}/unknown_key.yaml"),
    ("evaluate_segmentation", "--card {segmenter} {photos} --split val", "--split train test"),
    ("evaluate_segmentation", "--card {segmenter} {photos} --images -1", "--images"),
    ("evaluate_segmentation", "--card {segmenter} {photos} --backend abacus", "abacus"),
    ("evaluate_detection", "--card {detector}", "SET"),
    ("evaluate_detection", "{tmp}/empty", "--card"),
    ("evaluate_detection", "--card {segmenter} {photos}", "colour_segmenter.yaml"),
    ("evaluate_detection", "--card {detector} {tmp}/missing", "no such folder {tmp}/missing"),
    ("evaluate_detection", "--card {detector} {tmp}/missing.yaml", "{tmp}/missing.yaml"),
    ("evaluate_detection", "--card {detector} {room}", "{room} boxes"),
    ("evaluate_detection", "--card {detector} {photos} --split train", "{photos}/data.yaml train"),
    ("evaluate_detection", "--card {detector} {photos} --output {tmp}/out", "{tmp}/photos/images/a.png image"),
    ("evaluate_detection", "--card {detector} {photos} --classes {tmp}/missing.yaml", "{tmp}/missing.yaml"),
    ("evaluate_detection", "--card {detector} {photos} --threshold 0", "--threshold"),
    ("evaluate_detection", "--card {detector} {photos} --max-overlap 2", "--max-overlap"),
    ("octree_info", "", "MAP.ot"),
    ("octree_info", "{tmp}/missing.ot", "{tmp}/missing.ot"),
    ("octree_info", "{tmp}/text.bag", "{tmp}/text.bag OctoMap"),
    ("semantic_octree_benchmark", "--method hexagons", "--method hexagons semantic"),
    ("semantic_octree_benchmark", "--method semantic --res 0", "--res 0.01"),
    ("octree_convert", "{tmp}/map.ot", "OUT"),
    ("octree_convert", "{tmp}/missing.ot {tmp}/o.bt", "{tmp}/missing.ot"),
    ("octree_convert", "{tmp}/text.bag {tmp}/o.bt", "{tmp}/text.bag OctoMap"),
    ("track_boxes", "", "DET.txt"),
    ("track_boxes", "{tmp}/boxes.txt", "--out"),
    ("track_boxes", "{tmp}/missing.txt --out {tmp}/o.txt", "{tmp}/missing.txt"),
    ("track_boxes", "{tmp}/bad_trajectory.txt --out {tmp}/o.txt", "{tmp}/bad_trajectory.txt:1"),
    ("track_boxes", "{tmp}/boxes.txt --out {tmp}/text.bag/o.txt", "{tmp}/text.bag"),
    ("track_boxes", "{tmp}/boxes.txt --out {tmp}/o.txt --low 2", "low_confidence"),
    ("evaluate_tracking", "{tmp}/boxes.txt", "OUT.txt"),
    ("evaluate_tracking", "{tmp}/boxes.txt {tmp}/missing.txt", "{tmp}/missing.txt"),
    ("evaluate_tracking", "{tmp}/empty.txt {tmp}/boxes.txt", "reference"),
    ("tum_to_bag", "{room}", "OUT.bag"),
    ("tum_to_bag", "{tmp}/missing {tmp}/out.bag", "{tmp}/missing"),
    ("tum_to_bag", "{tmp}/empty {tmp}/out.bag", "{tmp}/empty rgb.txt"),
    ("tum_to_bag", "{room} {tmp}/text.bag/out.bag", "{tmp}/text.bag"),
    ("world_to_sdf", "", "WORLD"),
    ("world_to_sdf", "{tmp}/missing.yaml", "OUT_DIR"),
    ("world_to_sdf", "{tmp}/missing.yaml {tmp}/out --labels {labels}", "{tmp}/missing.yaml"),
    ("world_to_sdf", "{world} {tmp}/out --labels {tmp}/missing.yaml", "{tmp}/missing.yaml"),
    ("world_to_sdf", "{world} {tmp}/out --tour {tmp}/missing.yaml", "{tmp}/missing.yaml"),
    ("world_to_sdf", "{world} {tmp}/out --texture-size 0", "--texture-size"),
    ("world_to_sdf", "{world} {tmp}/text.bag/out", "{tmp}/text.bag"),
    ("render_textured_room", "", "OUT_DIR"),
    ("render_textured_room", "{tmp}/out --seconds 0", "--seconds"),
    ("render_textured_room", "{tmp}/text.bag --seconds 1", "{tmp}/text.bag"),
]


@pytest.fixture(name="tmp")
def fixture_tmp(tmp_path, repository):
    (tmp_path / "empty").mkdir()
    (tmp_path / "text.bag").write_text("not a bag\n")
    (tmp_path / "empty.txt").write_text("")
    (tmp_path / "boxes.txt").write_text("1,1,10,20,30,40,0.9,-1,-1,-1\n")
    (tmp_path / "unknown_key.yaml").write_text(
        (repository / "config/tum_freiburg1.yaml").read_text() + "focal: 500\n")
    for name, content in (("images/a.png", "no image"), ("labels/a.png", "no image"),
                          ("data.yaml", "names: [chair]\nval: images\n")):
        (tmp_path / "photos" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "photos" / name).write_text(content)
    (tmp_path / "bad_trajectory.txt").write_text("1 0 0 0 0 0 0 1\n2 0 0 zero 0 0 0 1\n")
    return tmp_path


@pytest.mark.parametrize("program", PROGRAMS)
def test_help_says_how_to_call_it(run_program, program):
    result = run_program(program, "--help")
    assert result.returncode == 0
    assert result.stdout.startswith(f"usage: {program} ")
    assert result.stderr == ""


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_full_disk_is_an_error(build_folder, program):
    with open("/dev/full", "w", encoding="ascii") as full:
        result = subprocess.run([build_folder / "devel/lib/semantic_slam" / program, "--help"],
                                stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert (result.returncode, result.stderr) == (1, f"{program}: cannot write to standard output\n")


@pytest.mark.parametrize("program, arguments, words", REFUSED)
def test_refuses_in_one_line(run_program, repository, room, tmp, program, arguments, words):
    places = {"tmp": tmp, "room": room.folder, "config": repository / "config/tum_freiburg1.yaml",
              "labels": repository / "config/labels.yaml", "world": repository / "config/worlds/home.yaml"}
    networks = repository / "test/testing/networks"
    places |= {"segmenter": networks / "colour_segmenter.yaml", "detector": networks / "block_detector.yaml",
               "photos": tmp / "photos"}
    before = sorted(tmp.rglob("*"))
    result = run_program(program, *arguments.format(**places).split())
    assert result.returncode == 1
    assert result.stdout == ""
    assert result.stderr.startswith(f"{program}: ")
    assert result.stderr.count("\n") == 1, result.stderr
    for word in words.format(**places).split():
        assert word in result.stderr
    assert sorted(tmp.rglob("*")) == before  # nothing half-written stays


def test_every_program_is_refused_something():
    assert {program for program, _, _ in REFUSED} == set(PROGRAMS)
