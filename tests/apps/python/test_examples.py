"""The examples of the documentation, at length; test_docs.py runs them as they stand there. Pictures and pages have tests of their
own. Left out: the sharing of shapes by id between processes."""
import multiprocessing
import sys

import numpy as np
import pytest

import trivet
from shapes import TrimeshSceneStandIn, TrimeshStandIn, TrimeshStandInPackage, at, box, box_arrays, table_with_cup, torus, torus_arrays


def test_meshes_from_arrays_are_put(tmp_path):
    (tmp_path / "table.obj").write_text(
        "".join("v %r %r %r\n" % tuple(v) for v in box_arrays(0.5, 0.5, 0.05)[0].tolist())
        + "".join("f %d %d %d\n" % tuple(f + 1) for f in box_arrays(1, 1, 1)[1]))
    mesh = TrimeshStandIn(*torus_arrays(20, 12))
    scene = trivet.Scene()
    table = scene.add("table", trivet.Shape.load(tmp_path / "table.obj"), pose=at(0, 0, 0.1), fixed=True)
    cup = scene.add("cup", mesh)
    result = cup.put(position=[0.1, 0.2, 1.5])
    assert result and result.end == "at_rest" and len(result.path) == result.num_motions
    assert cup.supports == [table] and table.loads() == [cup]
    mesh.apply_transform(cup.matrix)
    assert mesh.vertices[:, 2].min() == pytest.approx(0.15, abs=1e-5)
    assert scene.check().ok


def test_a_collision_shape_is_judged_and_the_other_is_drawn():
    scene = trivet.Scene()
    ring = scene.add("ring", torus(), collision=box(0.13, 0.13, 0.05))
    ring.put([0.0, 0.0, 1.0])
    assert ring.position[2] == pytest.approx(0.05, abs=1e-5), "it stands on the box"
    assert ring.weight == pytest.approx(9.80665 * 0.26 * 0.26 * 0.1 * 1000)
    scene.add("die", box(0.01, 0.01, 0.01)).put([0.0, 0.0, 1.0])
    assert scene["die"].position[2] == pytest.approx(0.11, abs=1e-5), "not in the hole of the ring"
    again = trivet.Scene.from_bytes(scene.to_glb())
    assert again.check().ok and again["die"].supports == [again["ring"]]
    camera = trivet.Camera.look_at([0.0, 0.0, 1.0], size=(40, 40))
    seen = scene.labels(camera)
    assert seen.pixels_visible[0] > 0 and (seen.instances == again.labels(camera).instances).all()
    assert len(again["ring"].shape.faces) == 12


def tub(half, height, wall):
    """A box without a lid."""
    parts = [(0, 0, half, half, wall), *((sx * half, sy * half, wall if sx else half + wall, wall if sy else half + wall, height)
                                         for sx, sy in ((1, 0), (-1, 0), (0, 1), (0, -1)))]
    vertices, faces = [], []
    for x, y, half_x, half_y, top in parts:
        corners, triangles = box_arrays(half_x, half_y, top / 2)
        faces.append(triangles + 8 * len(vertices))
        vertices.append(corners + [x, y, top / 2])
    return trivet.Shape(np.concatenate(vertices), np.concatenate(faces))


def poured(seed, turn="any"):
    scene = trivet.Scene()
    scene.add("tub", tub(0.1, 0.08, 0.005), pose=at(0, 0, 0.001), fixed=True)
    dice = [scene.add(f"die_{k}", box(0.02, 0.02, 0.02)) for k in range(20)]
    return scene, dice, scene.pour(dice, "tub", seed=seed, turn=turn)


def test_pours_a_heap():
    scene, dice, there = poured(1)
    assert len(there) == 20 and all(die.at_rest for die in there) and scene.check().ok
    low, high = scene["tub"].bounds
    assert all((low[:2] < die.center_mass[:2]).all() and (die.center_mass[:2] < high[:2]).all() for die in there)
    assert any(die.supports[0] in dice for die in there), "one lies on another"
    assert poured(1)[0].fingerprint == scene.fingerprint != poured(2)[0].fingerprint
    assert scene.undo() and not any(die.placed for die in dice), "it is one step"
    flat, _, level = poured(1, "none")
    assert level[0].matrix[2, 2] > 0.99
    with pytest.raises(trivet.BadInputError, match="out of the scene"):
        flat.pour(level[:1], "tub")
    with pytest.raises(trivet.BadInputError, match='"none", "up" or "any"'):
        flat.pour([], "tub", turn="round")
    with pytest.raises(trivet.BadInputError, match="in the scene"):
        flat.pour([], flat.add("bowl", box(1, 1, 1)))


def test_arranges_by_relations():
    scene = trivet.Scene()
    scene.add("table", box(0.5, 0.4, 0.35), pose=at(0, 0, 0.36), fixed=True)
    for i in (1, 2, 3):
        scene.add(f"mug_{i}", box(0.04, 0.04, 0.05))
    problem = {"seed": 2, "things": [{"objects": "mug_*"}],
               "relations": [{"is": "on", "a": "*", "b": "table"}, {"is": "keep", "a": "*", "distance": 0.02}]}
    result = scene.arrange(problem)
    assert sorted(result.settled) == ["mug_1", "mug_2", "mug_3"] and scene.check().ok
    assert [o.name for o in scene["mug_2"].supports] == ["table"] and scene.steps[-1] == 'arrange "mug_*"'
    before = scene.fingerprint
    problem["relations"].append({"is": "within", "a": "mug_1", "region": [[0, 0], [.05, 0], [.05, .2], [0, .2]]})
    with pytest.raises(trivet.Refused) as caught:
        scene.arrange(problem)
    assert caught.value.code == "no_arrangement" and caught.value.objects[0] == "mug_1"
    assert caught.value.result.numbers["missing"] == pytest.approx(0.015, abs=1e-6) and scene.fingerprint == before
    with pytest.raises(trivet.BadInputError, match="did you mean"):
        scene.arrange({"relations": [{"is": "onn", "a": "mug_1", "b": "table"}]})
    with pytest.raises(trivet.BadInputError, match="/things/0"):
        scene.arrange({"things": [{"object": "jug"}]})


def bin_shape():
    """A bin of 0.6 m with walls of 1 cm, 0.3 m high, open above: one shape of five boxes."""
    parts, count = [], 0
    for half, centre in (((0.3, 0.3, 0.005), (0, 0, 0.005)), ((0.005, 0.3, 0.15), (-0.295, 0, 0.15)),
                         ((0.005, 0.3, 0.15), (0.295, 0, 0.15)), ((0.3, 0.005, 0.15), (0, -0.295, 0.15)),
                         ((0.3, 0.005, 0.15), (0, 0.295, 0.15))):
        vertices, faces = box_arrays(*half)
        parts.append((vertices + centre, faces + count))
        count += len(vertices)
    return trivet.Shape(np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts]))


def scatter(number, seed):
    rng = np.random.default_rng(seed)
    shapes = [torus(radius=0.03, thickness=0.01), box(0.02, 0.03, 0.01), box(0.005, 0.005, 0.06)]
    scene = trivet.Scene()
    scene.add("bin", bin_shape(), pose=at(0, 0, 1e-5), fixed=True)
    for i in range(number):
        part = scene.add(f"part{i}", shapes[i % len(shapes)])
        for _ in range(100):
            if part.try_put([*rng.uniform(-.15, .15, 2), 1.2], wxyz=trivet.random_rotation(rng)):
                break
        else:
            raise AssertionError("100 places were refused")
    return scene


def test_fifty_objects_are_scattered_into_a_bin():
    scene = scatter(50, 7)
    verdict = scene.check()
    assert verdict.ok and verdict.stable
    for part in list(scene)[1:]:
        assert part.state == "stable"
        assert (np.abs(part.position[:2]) < 0.3).all()


def test_contacts_and_supports_are_arrays():
    scene = table_with_cup()
    contacts = scene.contacts()
    on_table = contacts.objects[:, 0] == 1
    assert on_table.any() and (contacts.objects[on_table, 1] == 0).all()
    assert contacts.point.shape == contacts.normal.shape == (len(contacts), 3)
    assert (contacts.gap >= 0).all() and contacts.normal[on_table, 2] == pytest.approx(1)
    assert set(contacts.type) <= {"point", "line", "area"}
    assert scene.support_graph().named_edges() == [("floor", "table"), ("table", "cup")]
    assert scene["table"].loads(recursive=True) == [scene["cup"]]


def test_contacts_become_a_table_of_pandas():
    pandas = pytest.importorskip("pandas", reason="python3-pandas is missing")
    scene = table_with_cup()
    rows = scene.contacts().to_pandas()
    assert isinstance(rows, pandas.DataFrame) and len(rows) == len(scene.contacts())
    assert set(zip(rows["object"], rows["support"])) == {("table", "floor"), ("cup", "table")}
    height = rows.groupby("object")["z"].mean()
    assert height["cup"] == pytest.approx(0.1, abs=1e-3) and height["table"] == pytest.approx(0, abs=1e-4)
    assert (rows["nz"] > 0.9).all() and rows["gap"].dtype == np.float64


def test_supports_become_a_graph_of_networkx():
    networkx = pytest.importorskip("networkx", reason="python3-networkx is missing")
    scene = table_with_cup()
    graph = scene.support_graph().to_networkx()
    assert list(networkx.topological_sort(graph)) == ["floor", "table", "cup"]
    assert networkx.descendants(graph, "table") == {"cup"} and networkx.is_directed_acyclic_graph(graph)


def test_pictures_and_labels_are_drawn_by_matplotlib(tmp_path):
    matplotlib = pytest.importorskip("matplotlib", reason="python3-matplotlib is missing")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    scene = table_with_cup()
    camera = scene.dome(1)[0]
    picture = scene.render(camera, samples=1)
    pyplot.imsave(tmp_path / "picture.png", picture)
    assert (np.round(255 * pyplot.imread(tmp_path / "picture.png")[..., :3]) == picture).all()
    figure, axes = pyplot.subplots()
    axes.imshow(scene.labels(camera).depth)
    points = scene.contacts().point
    axes.scatter(points[:, 0], points[:, 1])
    figure.savefig(tmp_path / "figure.png")
    pyplot.close(figure)
    assert pyplot.imread(tmp_path / "figure.png").std() > 0.05


def test_first_contact_of_a_fall_and_a_turn():
    cube = box()
    hit = trivet.first_contact(cube, at(0, 0, 1), cube, np.eye(4), along=[0, 0, -1], distance=3.0)
    assert hit and not hit.crossing
    assert hit.distance == pytest.approx(0.9, abs=1e-5) and hit.normal == pytest.approx([0, 0, 1])
    assert 0 <= hit.faces[0] < 12 and 0 <= hit.faces[1] < 12
    assert trivet.first_contact(cube, at(0, 0, 1), cube, np.eye(4), along=[0, 0, 1], distance=3.0) is None
    far = trivet.first_contact(cube, np.eye(4), cube, at(0, 0, 5), along=[0, 0, 10])  # its length is the way
    assert far is not None and far.distance > 1
    assert trivet.first_contact(cube, np.eye(4), cube, at(0, 0, 5), along=[0, 0, 10], distance=1.0) is None
    # A bar about z meets a post that stands at 90 degrees, and one at 225 beyond two quarter turns.
    bar, post = box(0.5, 0.001, 0.01), box(0.001, 0.001, 0.01)
    for degrees in (90.0, 225.0):
        angle = np.radians(degrees)
        there = at(0.4 * np.cos(angle), 0.4 * np.sin(angle), 0)
        turned = trivet.first_contact(bar, at(0.5, 0, 0), post, there, about=([0, 0, 1], [0, 0, 0]), degrees=300)
        assert turned and turned.degrees == pytest.approx(degrees, abs=0.5)


def test_foreign_scenes_are_judged():
    cube = TrimeshStandIn(*box_arrays(0.05, 0.05, 0.05))
    foreign = TrimeshSceneStandIn([("a", cube, at(0, 0, 0.05 + 1e-6)), ("b", cube, at(0.03, 0, 0.05 + 1e-6)),
                                   ("c", cube, at(1, 0, 0.7))])
    scene = trivet.Scene.from_trimesh(foreign)
    verdict = scene.check(friction=0.5)
    assert not verdict.ok
    assert [(one.a, one.b) for one in verdict.crossings] == [("node_a", "node_b")]
    assert "node_c" in verdict.not_at_rest
    found = trivet.interpenetrations([cube] * 3, [at(0, 0, 0), at(0.03, 0, 0), at(1, 0, 0)])
    assert [(one.a, one.b) for one in found] == [(0, 1)] and found[0].crossings > 0


def test_scenes_go_to_trimesh_and_back(monkeypatch):
    scene = table_with_cup()
    scene.add("half a cup", scene["cup"].shape, scale=0.5).put([-0.2, -0.2, 1], [1, 1, 0, 0])
    scene.add("out of the scene", box())
    monkeypatch.setitem(sys.modules, "trimesh", TrimeshStandInPackage)
    there = scene.to_trimesh()
    assert there.nodes_geometry == ["table", "cup", "half a cup"] and len(there.geometry) == 2
    back = trivet.Scene.from_trimesh(there, fixed=["table"])
    for one in back:
        assert one.matrix == pytest.approx(scene[one.name].matrix, abs=1e-12)
        assert (one.shape.faces == scene[one.name].shape.faces).all()
    assert back["cup"].shape == back["half a cup"].shape and back.check().ok
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(trivet.EnvironmentFailure, match="trimesh is missing"):
        scene.to_trimesh()


def test_positions_of_another_program_are_judged():
    cube = box()
    apart = at(0.2, 0, 0)
    assert trivet.interpenetrations([cube, cube], [np.eye(4), apart]) == []
    shown = np.float32(cube.vertices + [0.2, 0, 0])
    assert trivet.interpenetrations([cube, cube], [np.eye(4), apart], positions=[None, shown]) == []
    shown[0] = 0, 0, 0  # one corner went into the other
    assert trivet.interpenetrations([cube, cube], [np.eye(4), apart], positions=[None, shown])[0].crossings > 0


def test_pushes_and_turns_carry_loads():
    scene = trivet.Scene()
    plate = scene.add("plate", box(0.1, 0.1, 0.01))
    plate.put([0, 0, 0.5])
    scene.add("cup", box(0.02, 0.02, 0.02)).put(on=plate, at=[0, 0])
    scene.add("wall", box(0.05, 0.5, 0.2), pose=at(0.5, 0, 0.2 + 2e-6), fixed=True)
    result = plate.push([1, 0], 1.0)
    assert (result.end, result.blocked_by, result.carried) == ("blocked", "wall", ("cup",))
    assert scene["cup"].position[0] == pytest.approx(0.35, abs=1e-4)
    assert scene["cup"].turn(45).turned_deg == pytest.approx(45)
    before = scene.fingerprint
    with scene.drag("plate", "push") as hand:
        for y in np.linspace(0, 0.2, 5):
            step = hand.follow([0.2, y])
            assert step, step.reason
        assert set(hand.poses()) == {"plate", "cup"}
        with pytest.raises(trivet.SceneBusy):
            plate.put([0, 0, 1])
        assert scene.fingerprint == before
    assert hand.result and plate.position[:2] == pytest.approx([0.2, 0.2], abs=1e-3)
    assert scene.undo() and scene.fingerprint == before
    with pytest.raises(ZeroDivisionError):
        with scene.drag("plate", "push") as hand:
            hand.follow([0, 0])
            1 / 0
    assert scene.fingerprint == before and scene.check().ok


def test_zlists_are_arrays():
    scene = trivet.Scene(floor=False)
    for k in range(3):  # three boxes of 0.1 m, one above the other, 0.1 m between them
        scene.add(f"b{k}", box(), pose=at(0, 0, 0.2 * k))
    lists = scene.zlists([0, 0, -1], resolution=16, num_threads=1)
    assert (lists.width, lists.height) == (16, 16) and lists.names == ("b0", "b1", "b2")
    seen = lists.at(8, 5)
    assert [lists.names[o] for o in seen.object] == sorted([lists.names[o] for o in seen.object], reverse=True)
    for k, height in zip((2, 1, 0), (0.4, 0.2, 0.0)):
        depths = seen.nearest[seen.object == k]
        assert depths.min() == pytest.approx(-height - 0.05, abs=1e-5)
        assert seen.farthest[seen.object == k].max() == pytest.approx(-height + 0.05, abs=1e-5)
    assert lists.depth() == pytest.approx(np.full((16, 16), -0.45), abs=1e-5) and lists.lengths().min() >= 6
    for wrong in (dict(direction=[0, 0, 0]), dict(resolution=0), dict(max_bytes=10), dict(region=[0, 0, 1])):
        with pytest.raises(trivet.BadInputError):
            scene.zlists(**wrong)
    with pytest.raises(trivet.BadInputError, match="pixel"):
        lists.at(16, 0)


def test_all_or_nothing_and_snapshots():
    scene = trivet.Scene()
    table = scene.add("table", box(0.5, 0.5, 0.05), pose=at(0, 0, 0.05 + 2e-6), fixed=True)
    plate, cup = scene.add("plate", box(0.1, 0.1, 0.01)), scene.add("cup", torus(radius=0.3, thickness=0.01))
    before = scene.snapshot()
    with pytest.raises(trivet.Refused) as caught:
        with scene.transaction():
            plate.put(on=table, at=[0.3, 0.2])
            assert plate.at_rest
            cup.put(on=plate, at="anywhere", keep=5.0)
    assert caught.value.code in trivet.CAUSES and caught.value.objects[0] == "cup"
    assert scene.fingerprint == before.fingerprint and not plate.placed and not scene.can_redo
    with scene.transaction():
        plate.put(on=table, at=[0.3, 0.2])
        plate.push([1, 0], 0.02)
    after = scene.fingerprint
    assert scene.undo() and scene.fingerprint == before.fingerprint
    assert scene.redo() and scene.fingerprint == after
    scene.restore(before)
    assert scene.fingerprint == before.fingerprint and not scene.can_undo
    plate.put(on=table, at=[0.3, 0.2])  # the object of before the snapshot is still that
    assert plate.at_rest


def farm_scene(seed):
    return scatter(4, seed).snapshot()


@pytest.mark.parametrize("method", ["spawn", "fork"])
def test_a_farm_gives_the_same_bits(method):
    with multiprocessing.get_context(method).Pool(2) as pool:
        made = pool.map(farm_scene, [1, 2])
    here = [farm_scene(1), farm_scene(2)]
    for there, own in zip(made, here):
        for a, b in zip(there.scene(), own.scene()):
            assert a.name == b.name and (a.pose == b.pose).all()
    assert made[0].fingerprint != made[1].fingerprint
