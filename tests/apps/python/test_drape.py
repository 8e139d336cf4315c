"""Cloths and cables that come to rest."""
import numpy as np
import pytest

import trivet
from shapes import at, box


def scene_with_block():
    scene = trivet.Scene()
    scene.add("block", box(0.08, 0.08, 0.15), pose=at(0, 0, 0.150001), fixed=True)
    return scene


def test_a_cloth_rests_and_says_how():
    scene = scene_with_block()
    cloth = scene.drape("cloth", size=[0.3, 0.3], cell=0.02, position=[0, 0, 0.32], material="cotton")
    rest = cloth.flexible
    assert rest["net_force"] < 1e-3 and rest["stable"]
    assert rest["balance"] == pytest.approx(1, abs=1e-4)
    assert [s["name"] for s in rest["supports"]] == ["block"]
    assert cloth.middle.shape == (rest["vertices"], 3)
    assert cloth.middle[:, 2].max() == pytest.approx(0.3, abs=5e-3)  # it arches over the edges
    assert cloth.middle[:, 2].min() < 0.28
    assert scene["block"].flexible is None and scene["block"].middle is None
    assert scene.check().ok


def test_a_cable_hangs_as_a_catenary():
    scene = trivet.Scene(floor=False)
    ends = [[-0.5, 0, 1], [0.5, 0, 1]]
    cable = scene.drape("cable", path=[ends[0], [0, 0, 1 - np.sqrt(0.11)], ends[1]], pins=ends, bending=0)
    x, _, z = cable.middle.T
    a = next(a for a in np.arange(0.2, 2, 1e-4) if 2 * a * np.sinh(0.5 / a) < 1.2)
    # A lead is 40 g/m on 5 kN: it stretches by less than 1e-3.
    assert np.abs(z - 1 - a * (np.cosh(x / a) - np.cosh(0.5 / a))).max() < 1e-3


def test_refusals():
    scene = scene_with_block()
    with pytest.raises(trivet.Refused, match="block"):
        scene.drape("cloth", size=[0.3, 0.3], cell=0.02, position=[0, 0, 0.2])
    with pytest.raises(trivet.Refused, match="did not come to rest"):
        scene.drape("cloth", size=[0.3, 0.3], cell=0.02, position=[0, 0, 0.32], steps=2)
    assert "cloth" not in [o.name for o in scene]
