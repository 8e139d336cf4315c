"""Scenes of our own mended and settled; the clearance that proved a scene goes with it."""
import numpy as np
import pytest

import trivet
from shapes import at, box


def bad_scene():
    """Two boxes that are 4 mm in each other, and one 10 mm above the floor."""
    scene = trivet.Scene()
    for name, x in (("a", 0.0), ("b", 0.2), ("c", 0.5)):
        scene.add(name, box()).put([x, 0, 0.1])
    scene["b"].translate([-0.104, 0, 0], free=True)
    scene["c"].translate([0, 0, 0.01], free=True)
    assert not scene.check()
    return scene


def test_mending_is_one_step_and_tells_every_move():
    scene = bad_scene()
    before = {o.name: np.array(o.pose) for o in scene}
    report = scene.mend()
    assert scene.check() and report["unable"] == [] and report["supports_kept"] == report["supports_meant"] == 3
    for move in report["moved"]:
        assert move["metres"] < 0.02
        assert np.allclose(scene[move["object"]].pose[:3, 3], move["to"])
    assert scene.mend()["moved"] == []
    scene.undo()
    scene.undo()
    assert all(np.array_equal(o.pose, before[o.name]) for o in scene)


def test_settling_moves_only_what_is_named():
    scene = bad_scene()
    report = scene.settle_all(only=[scene["c"]])
    assert [move["object"] for move in report["moved"]] == ["c"]
    assert report["moved"][0]["metres"] == pytest.approx(0.01, abs=1e-5) and "tolerance" not in report
    assert scene.settle_all("c")["moved"] == []


def test_bad_arguments():
    scene = bad_scene()
    with pytest.raises(trivet.Refused, match="nobody"):
        scene.mend(only=["nobody"])
    with pytest.raises(trivet.BadInputError, match="tolerance"):
        scene.mend(tolerance=-1)
    with pytest.raises(trivet.BadInputError, match="lift"):
        scene.settle_all(lift=2)


def test_a_scene_that_has_shrunk_is_true_when_it_is_read_back(tmp_path):
    scene = trivet.Scene()
    scene.add("wall", box(4, 0.1, 4), pose=at(0, 2, 4.1), fixed=True)
    scene.add("a", box()).put([0, 0, 1])
    assert scene.check()
    scene["wall"].remove()
    assert scene.check()
    scene.save(tmp_path / "small.glb")
    again = trivet.Scene.load(tmp_path / "small.glb")
    assert again.check() and np.array_equal(again["a"].pose, scene["a"].pose)
