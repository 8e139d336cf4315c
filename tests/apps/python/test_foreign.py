"""Scenes of other programs in Python: judged, settled, mended, drawers, written back."""
from pathlib import Path

import numpy as np
import pytest

import trivet

CASES = Path(__file__).resolve().parents[3] / "tests" / "core" / "io" / "foreign" / "cases"


@pytest.fixture
def drawer(tmp_path):
    (tmp_path / "drawer.xml").write_bytes((CASES / "drawer.xml").read_bytes())
    return trivet.Foreign.load(tmp_path / "drawer.xml")


def test_a_scene_is_judged_and_settled(drawer, tmp_path):
    assert (drawer.format, drawer.key, drawer.not_judged) == ("MJCF", "open", [])
    kinds = {f["object"]: f["kind"] for f in drawer.check()["findings"]}
    assert kinds == {"sunk": "passes through", "in the drawer": "floats"}
    moved = {move["object"]: move["metres"] for move in drawer.settle()["moved"]}
    assert moved == {"sunk": pytest.approx(0.002, abs=1e-5), "in the drawer": pytest.approx(0.01, abs=1e-5)}
    assert drawer.check()["ok"]
    drawer.save(tmp_path / "out.xml")
    assert trivet.Foreign.load(tmp_path / "out.xml").check()["ok"]


def test_drawers(drawer, tmp_path):
    assert drawer.joints["slide"]["upper"] == 0.3 and drawer.joints["lid"]["kind"] == "hinge"
    drawer.settle()
    before = drawer.poses()["in the drawer"]
    move = drawer.move_joint("slide", 0)
    assert (move["end"], move["value"], move["carried"]) == ("reached", 0.0, ["in the drawer"])
    assert np.allclose(drawer.poses()["in the drawer"][:3, 3] - before[:3, 3], [0, 0.2, 0], atol=1e-12)
    assert drawer.move_joint("lid", 200)["end"] == "limit"
    drawer.save(tmp_path / "out.xml")
    again = trivet.Foreign.load(tmp_path / "out.xml")
    assert again.joints["slide"]["value"] == 0 and again.check()["ok"]
    with pytest.raises(trivet.BadInputError, match="accepted: \"slide\", \"lid\""):
        drawer.move_joint("door", 1)


def test_mending_and_what_was_meant(tmp_path):
    (tmp_path / "two.xml").write_text("""<mujoco><worldbody><geom type="plane" size="1 1 1"/>
      <body name="a" pos="0 0 0.05"><freejoint/><geom type="box" size="0.05 0.05 0.05"/></body>
      <body name="b" pos="0.096 0 0.05"><freejoint/><geom type="box" size="0.05 0.05 0.05"/></body></worldbody></mujoco>""")
    scene = trivet.Foreign.load(tmp_path / "two.xml")
    assert {o["object"]: o["on"][0]["object"] for o in scene.intent()["objects"]} == {"a": "floor", "b": "floor"}
    report = scene.mend()
    assert scene.check()["ok"] and report["supports_kept"] == report["supports_meant"]


def test_bad_arguments(tmp_path):
    (tmp_path / "x.xml").write_text("<mujoco><worldbody/></mujoco>")
    with pytest.raises(trivet.BadInputError, match="keyframe"):
        trivet.Foreign.load(tmp_path / "x.xml", key="home")
    with pytest.raises(trivet.BadInputError, match="collide"):
        trivet.Foreign.load(tmp_path / "x.xml", collide="soft")
    with pytest.raises(trivet.BadInputError, match="is no file"):
            trivet.Foreign.load(tmp_path / "none.xml")
    with pytest.raises(TypeError):
        trivet.Foreign()
