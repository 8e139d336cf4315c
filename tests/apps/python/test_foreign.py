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


def test_states_of_an_archive(tmp_path):
    """Arrays of qpos are states of the scene, and so are written."""
    path = tmp_path / "two.xml"
    path.write_text('<mujoco><worldbody><geom type="plane" size="2 2 .1"/>'
                    '<body name="a"><freejoint/><geom type="box" size=".05 .05 .05"/></body>'
                    '<body name="b"><freejoint/><geom type="box" size=".05 .05 .05"/></body></worldbody></mujoco>')
    for i, height in enumerate((0.09, 0.03)):
        np.save(tmp_path / "state.npy", [0, 0, height, 1, 0, 0, 0, 0.3, 0, 0.05, 1, 0, 0, 0])
        scene = trivet.Foreign.load(path, key=str(tmp_path / "state.npy"))
        scene.settle()
        scene.save(tmp_path / "rest.npy")
        qpos = np.load(tmp_path / "rest.npy")
        assert qpos.shape == (14,) and qpos[2] == pytest.approx(0.05, abs=1e-5)
        assert qpos[7:].tolist() == [0.3, 0, 0.05, 1, 0, 0, 0]
        assert trivet.Foreign.load(path, key=str(tmp_path / "rest.npy")).check()["ok"], i


def test_friction_by_the_rules_of_an_engine(tmp_path):
    path = tmp_path / "slope.xml"
    path.write_text('<mujoco><worldbody><body euler="0 20 0"><geom type="box" size="1 1 .1" pos="0 0 -.1" friction=".3"/>'
                    '</body><body name="b" euler="0 20 0" pos="0.0171010071662834 0 0.0469846310392954"><freejoint/>'
                    '<geom type="box" size=".05 .05 .05" friction=".5"/></body></worldbody></mujoco>')
    holds = {rules: trivet.Foreign.load(path, rules=rules).check()["ok"]
             for rules in ("format", "mujoco", "bullet", "gazebo", "trivet")}
    assert holds == {"format": True, "mujoco": True, "bullet": False, "gazebo": False, "trivet": False}
    with pytest.raises(trivet.BadInputError, match="rules"):
        trivet.Foreign.load(path, rules="ode")


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
