"""render_training_set: folders that training reads, complete or absent, and the same every time."""

import pytest

IMAGES = 2


@pytest.fixture(name="render")
def fixture_render(run_program, build_folder, tmp_path):
    """render(name, option...) returns the folder."""
    if not (build_folder / "devel/lib/semantic_slam/render_training_set").exists():
        pytest.skip("there is no simulator: Embree is not installed")

    def render(name, *options):
        out = tmp_path / name
        result = run_program("render_training_set", out, "--worlds", "1", "--images", str(IMAGES), "--size", "96x72",
                             *options)
        assert result.returncode == 0, result.stderr
        return out

    return render


def files_of(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_writes_images_with_all_of_their_truth(render):
    world = render("set") / "world_00000"
    for kind in ("rgb", "labels", "instances", "boxes"):
        assert len(list((world / kind).iterdir())) == IMAGES
    assert not (world / "depth").exists()
    assert (render("deep", "--depth") / "world_00000/depth").exists()


def test_gives_the_same_bytes_and_other_ones_for_another_seed_or_split(render):
    first = files_of(render("first"))
    assert files_of(render("second")) == first
    assert files_of(render("third", "--seed", "2")) != first
    assert files_of(render("fourth", "--split", "validation")) != first


def test_refuses_to_mix_sets(render, run_program):
    out = render("set")
    for options in (("--split", "validation"), ("--seed", "2"), ("--size", "64x64"), ("--images", "3"), ("--depth",)):
        alike = {"--images": str(IMAGES), "--size": "96x72", options[0]: options[-1]}
        flags = [word for option in alike.items() for word in dict.fromkeys(option)]
        result = run_program("render_training_set", out, "--worlds", "2", *flags)
        assert result.returncode == 1 and "set.yaml" in result.stderr and result.stderr.count("\n") == 1
    assert not (out / "world_00001").exists()
    render("set")


def test_keeps_what_is_complete_and_begins_the_rest_anew(render):
    out = render("set")
    complete = files_of(out)
    (out / "world_00000/rgb.txt").write_text("kept")
    assert (render("set") / "world_00000/rgb.txt").read_text() == "kept"
    (out / "world_00000").rename(out / "unfinished_world_00000")
    assert files_of(render("set")) == complete
