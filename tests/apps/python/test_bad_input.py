"""Wrong input gives an exception that names what, the value and what is accepted; nothing crashes."""
import re

import numpy as np
import pytest

import trivet
from shapes import at, box, box_arrays, table_with_cup

VERTICES, FACES = box_arrays(1, 1, 1)


def with_value(array, where, value):
    out = np.array(array)
    out[where] = value
    return out


@pytest.mark.parametrize("vertices, faces, says", [
    (with_value(VERTICES, (3, 1), np.nan), FACES, ["vert", "3", "nan"]),
    (with_value(VERTICES, (0, 0), np.inf), FACES, ["vert", "0", "inf"]),
    (VERTICES[:, :2], FACES, ["vertices", "(8, 2)", "(n, 3)"]),
    (VERTICES.ravel(), FACES, ["vertices", "(24,)", "(n, 3)"]),
    (VERTICES.astype(complex), FACES, ["vertices", "complex128"]),
    (VERTICES.astype(str), FACES, ["vertices", "<U"]),
    (VERTICES.astype(object), FACES, ["vertices", "object"]),
    (VERTICES > 0, FACES, ["vertices", "bool"]),
    ([[1, 2, 3], [4, 5]], FACES, ["vertices"]),
    ("text", FACES, ["vertices"]),
    (None, FACES, ["vertices"]),
    (VERTICES, FACES.astype(float), ["faces", "float64", "whole numbers"]),
    (VERTICES, FACES[:, :2], ["faces", "(12, 2)", "(m, 3)"]),
    (VERTICES, np.zeros((5, 4), int), ["faces", "(5, 4)", "triangulate"]),
    (VERTICES, with_value(FACES, (4, 2), 8), ["faces", "row 4", "vertex 8", "0 to 7"]),
    (VERTICES, with_value(FACES, (5, 0), -1), ["faces", "row 5", "vertex -1", "0 to 7"]),
    (VERTICES, with_value(FACES.astype(np.int64), (0, 0), 2 ** 32), ["faces", "row 0", "4294967296"]),
    (VERTICES, with_value(FACES.astype(np.uint64), (0, 0), 2 ** 63), ["faces", "row 0", str(2 ** 63)]),
    (VERTICES, np.zeros((0, 3), int), ["triangle"]),
    (np.zeros((0, 3)), np.zeros((0, 3), int), ["triangle"]),
    (np.zeros((0, 3)), FACES, ["faces", "row 0"]),
])
def test_arrays_that_make_no_shape(vertices, faces, says):
    with pytest.raises(trivet.BadInputError) as caught:
        trivet.Shape(vertices, faces)
    for part in says:
        assert part in str(caught.value), str(caught.value)


@pytest.mark.parametrize("mesh", [42, None, object(), [1, 2, 3]])
def test_what_is_no_mesh(mesh):
    with pytest.raises(trivet.BadInputError, match="accepted.*faces"):
        trivet.Shape(mesh)


def test_files_that_are_no_models(tmp_path):
    (tmp_path / "text.obj").write_text("hello")
    for path in (tmp_path / "missing.obj", tmp_path / "text.obj", tmp_path):
        with pytest.raises(trivet.BadInputError, match=re.escape(str(path))):
            trivet.Shape.load(path)
    with pytest.raises(trivet.BadInputError):
        trivet.Scene.load(tmp_path / "missing.glb")
    with pytest.raises(trivet.BadInputError):
        trivet.Scene.from_bytes(b"not glTF")
    with pytest.raises(trivet.BadInputError):
        trivet.Snapshot.from_bytes(table_with_cup().to_glb()[:500])


def test_a_missing_importer(monkeypatch, tmp_path):
    monkeypatch.setenv("TRIVET_IMPORTER", str(tmp_path / "nothing"))
    with pytest.raises(trivet.EnvironmentFailure, match="TRIVET_IMPORTER"):
        trivet.Shape.load("x.obj")


BAD_CALLS = [
    (lambda s: s["cup"].put([0, 0, np.nan]), ["position", "nan", "finite"]),
    (lambda s: s["cup"].put([0, 0]), ["position", "(2,)", "3 finite"]),
    (lambda s: s["cup"].put("here"), ["position", "here", "3 finite"]),
    (lambda s: s["cup"].put([0, 0, 1e300]), ["position", "1e+300"]),
    (lambda s: s["cup"].put([0, 0, 1], [0, 0, 0, 0]), ["rotation", "quaternion"]),
    (lambda s: s["cup"].put([0, 0, 1], [1, 0, 0]), ["wxyz", "4 finite"]),
    (lambda s: s["cup"].put([0, 0, 1], on="table"), ["position", "accepted: op, object, on"]),
    (lambda s: s["cup"].put(on=5), ["on", "5"]),
    (lambda s: s["cup"].put(on="table", at="here"), ["at", "here", "anywhere"]),
    (lambda s: s["cup"].put(on="table", at=[0, 0, 0]), ["at", "(3,)"]),
    (lambda s: s["cup"].put(on="table", keep=-1), ["keep", "-1"]),
    (lambda s: s["cup"].put(on="table", keep=float("nan")), ["keep", "nan"]),
    (lambda s: s["cup"].put(on="table", seed=-1), ["seed", "-1"]),
    (lambda s: s["cup"].put(on="table", seed=2 ** 70), ["seed", str(2 ** 70)]),
    (lambda s: s["cup"].put([0, 0, 1], budget=-1), ["budget", "-1"]),
    (lambda s: s["cup"].put([0, 0, 1], budget=float("inf")), ["budget", "inf"]),
    (lambda s: s["cup"].push([0, 0], 1), ["direction"]),
    (lambda s: s["cup"].push([1, 0]), ["distance", "missing"]),
    (lambda s: s["cup"].push(), ["push", "a target is missing"]),
    (lambda s: s.drag("cup", "push", speed=3), ["speed", "distance"]),
    (lambda s: s["cup"].push([1, 0], 1, together="cup"), ["together"]),
    (lambda s: s["cup"].turn(1e9), ["angle_deg", "accepted"]),
    (lambda s: s["cup"].turn(5, about="me"), ["about", "me", "normal"]),
    (lambda s: s["cup"].rotate([0, 0, 0], 5), ["axis"]),
    (lambda s: s.drag("cup", "put"), ["op", "put", "push"]),
    (lambda s: setattr(s["cup"], "material", "butter"), ["material", "butter"]),
    (lambda s: setattr(s["cup"], "material", {"friction": -1}), ["friction", "-1"]),
    (lambda s: s.add("x", box(), pose=np.zeros((4, 4))), ["pose", "x"]),
    (lambda s: s.add("x", box(), pose=np.eye(3)), ["pose", "(3, 3)", "(4, 4)"]),
    (lambda s: s.add("x", box(), pose=np.diag([1, 1, -1, 1.])), ["pose", "mirrored"]),
    (lambda s: s.add("x", box(), pose=np.diag([1, 1, 2, 1.])), ["pose", "unequally"]),
    (lambda s: s.add("x", box(), pose=np.full((4, 4), np.nan)), ["pose", "finite"]),
    (lambda s: s.add("x", box(), scale=0), ["scale", "0"]),
    (lambda s: s.add("x", box(), scale=float("nan")), ["scale", "nan"]),
    (lambda s: s.add("x", box(), up="x"), ["up", "x", "y"]),
    (lambda s: s.add("x", "no shape"), ["str", "accepted"]),
    (lambda s: s.add(5, box()), ["name", "5"]),
    (lambda s: s.check(friction=0), ["friction", "0"]),
    (lambda s: s.check(friction=float("nan")), ["friction", "nan"]),
    (lambda s: s.restore(s), ["snapshot"]),
    (lambda s: s.perform([]), ["empty"]),
    (lambda s: s.perform([{"op": "jump", "object": "cup"}]), ["jump", "put"]),
    (lambda s: s.export("x.abc"), ["x.abc"]),
    (lambda s: s.export("x.xml", collision="fuzzy"), ["fuzzy"]),
    (lambda s: trivet.Scene(clearance=-1), ["clearance", "-1"]),
    (lambda s: trivet.Scene(gravity=1), ["gravity", "max_motions"]),
    (lambda s: trivet.Scene(max_motions="many"), ["max_motions", "many", "whole number"]),
    (lambda s: trivet.Scene.from_poses(["a"], [box()], []), ["1 names", "0 poses"]),
    (lambda s: trivet.Scene.from_poses(["a", "a"], [box()] * 2, [np.eye(4)] * 2), ["a"]),
    (lambda s: trivet.Scene.from_poses(["floor"], [box()], [np.eye(4)]), ["floor"]),
    (lambda s: trivet.first_contact(box(), np.eye(4), box(), np.eye(4)), ["along", "about"]),
    (lambda s: trivet.first_contact(box(), np.eye(4), box(), np.eye(4), along=[0, 0, 0]), ["length 0"]),
    (lambda s: trivet.first_contact(box(), np.eye(4), box(), np.eye(4), about=[1, 2, 3]), ["about"]),
    (lambda s: trivet.interpenetrations([box()], [np.eye(4)], positions=[np.zeros((3, 3))]), ["3", "8"]),
    (lambda s: trivet.interpenetrations([box()], [np.eye(4)], positions=[np.full((8, 3), np.nan)]), ["row 0", "nan"]),
]


def follow(scene, op, goal):
    with scene.drag("cup", op) as hand:
        hand.follow(goal)


NAN = float("nan")
FOLDED = []
FOLDED.append(FOLDED)

# Once taken for something else, or left out, without a word.
UNSEEN = [
    (lambda s: s["cup"].put([1, 0, 1], at=[5, 5]), ["put", "cup", "position", "on, at"]),
    (lambda s: s["cup"].put(at=[0.2, 0.2], keep=0.01), ["\"on\" is missing"]),
    (lambda s: s["cup"].put([1, 0, 1], seed=3, least_margin=9), ["goes with \"on\""]),
    (lambda s: s["cup"].put([1, 0, 1], most_friction="junk", keep=np.zeros(2)), ["keep", "a number"]),
    (lambda s: s["cup"].put(on="table", seed=1.5), ["seed", "1.5", "whole number"]),
    (lambda s: s["cup"].put([0, 0, 1], settle_left="x"), ["settle_left", "x", "True"]),
    (lambda s: s["cup"].turn("45"), ["degrees", "45", "a number"]),
    (lambda s: s["cup"].turn(5, settle=3), ["settle", "3", "True"]),
    (lambda s: s["cup"].put([0, 0, 1], budget=True), ["budget", "True"]),
    (lambda s: setattr(s["cup"], "fixed", "no"), ["fixed", "no", "True"]),
    (lambda s: setattr(s["cup"], "locked", 2), ["locked", "2"]),
    (lambda s: s["cup"].loads("all"), ["recursive", "all"]),
    (lambda s: s.add("x", box(), scale="2"), ["scale", "2"]),
    (lambda s: s.add("x", box(), fixed="no"), ["fixed", "no"]),
    (lambda s: setattr(s, "time_budget", -1), ["time_budget", "-1", "seconds"]),
    (lambda s: setattr(s, "time_budget", NAN), ["time_budget", "nan"]),
    (lambda s: s.perform([{"op": "lock", "object": "cup"}], budget=-1), ["budget", "-1"]),
    (lambda s: setattr(s.settle, "clearance", NAN), ["clearance", "nan", "metres"]),
    (lambda s: setattr(s.settle, "max_motions", -3), ["max_motions", "-3", "1 to"]),
    (lambda s: setattr(s.settle, "whole_at_rest", "no"), ["whole_at_rest", "no"]),
    (lambda s: setattr(s.settle, "robust", 1), ["robust", "1"]),
    (lambda s: setattr(s.settle, "gravity", 1), ["gravity", "max_motions"]),
    (lambda s: trivet.Scene(max_motions=-1), ["max_motions", "-1"]),
    (lambda s: trivet.Scene(max_motions=10 ** 30), ["max_motions", "10000000000", "1 to 1000000000"]),
    (lambda s: trivet.Scene(perfect_friction=2), ["perfect_friction", "2"]),
    (lambda s: trivet.Scene(floor="no"), ["floor", "no", "True"]),
    (lambda s: trivet.Scene.from_poses(["a"], [box()], [np.eye(4)], materials={"zzz": "wood"}), ["materials", "zzz"]),
    (lambda s: trivet.Scene.from_poses(["a", "b"], [box()] * 2, [np.eye(4)] * 2, fixed="ab"), ["fixed", "ab"]),
    (lambda s: trivet.Scene.from_poses(["a"], [box()], [np.eye(4)], fixed=["c"]), ["fixed", "c"]),
    (lambda s: s.export("x.xml", density=NAN), ["density", "nan", "kilograms"]),
    (lambda s: s.export("x.xml", hull_clearance=-1), ["hull_clearance", "-1", "metres"]),
    (lambda s: s.export("x.xml", friction=-1), ["friction", "-1", "0 to"]),
    (lambda s: s.render(size=(8, 8), samples=1, transparent="no"), ["transparent", "no"]),
    (lambda s: trivet.Shape(np.ma.masked_greater(VERTICES, 0), FACES), ["vertices", "masked"]),
    (lambda s: s.save("a\0b.glb"), ["path", "a\\x00b.glb", "NUL"]),
]

# Once errors of Python, or of the binding.
NO_PYTHON_ERRORS = [
    (lambda s: s.add("x", box(), material=3), ["material", "3", "materials()"]),
    (lambda s: s.add("x", box(), material={1: 2}), ["material", "1"]),
    (lambda s: s.add("x", box(), up=3), ["up", "3", "y"]),
    (lambda s: s.add("x", box(), scale=10 ** 400), ["scale", "1000"]),
    (lambda s: setattr(s["cup"], "material", {"friction": FOLDED}), ["material: /friction", "within each other"]),
    (lambda s: setattr(s["cup"], "group", 3), ["group", "3"]),
    (lambda s: s["cup"].turn(1j), ["degrees", "1j"]),
    (lambda s: s["cup"].turn(5, about=3), ["about", "3"]),
    (lambda s: s["cup"].put(on="table", seed="x"), ["seed", "x", "whole number"]),
    (lambda s: s["cup"].push(to=[1, 1], via=3), ["via", "3", "2 numbers"]),
    (lambda s: s["cup"].translate([0, 0, 1], via=3), ["via", "3", "3 numbers"]),
    (lambda s: s["cup"].push([1, 0], 1, together=3), ["together", "3"]),
    (lambda s: s.drag("cup", "push", speed=object()), ["speed", "unknown option"]),
    (lambda s: s.perform([3]), ["operations: 0", "3", "dict"]),
    (lambda s: s.perform("abc"), ["operations", "abc", "list"]),
    (lambda s: s.perform({"op": "lock"}), ["operations: 0", "op"]),
    (lambda s: s.perform([{"op": "put", "object": "cup", "position": FOLDED}]), ["operations: 0", "within each other"]),
    (lambda s: s.perform([{"op": "lock", "object": "\ud800"}]), ["operations: 0", "ud800", "UTF-8"]),
    (lambda s: s.arrange(3), ["problem", "3"]),
    (lambda s: s.check(num_threads="x"), ["num_threads", "x"]),
    (lambda s: s.zlists(resolution="x"), ["resolution", "x", "8192"]),
    (lambda s: s.drag("cup", []), ["op", "push"]),
    (lambda s: s.render(size=(8, 8), samples=1, highlight=3), ["highlight", "3"]),
    (lambda s: s.render(size=(8, 8), samples=1, highlight=[box()]), ["highlight", "Shape"]),
    (lambda s: s.render(size=(8, 8), samples=1, progress=3), ["progress", "3", "function"]),
    (lambda s: s.labels(classes=3), ["classes", "3"]),
    (lambda s: s.view(highlight=3), ["highlight", "3"]),
    (lambda s: s.view(show=3), ["show", "3", "hulls"]),
    (lambda s: s.view().save(None), ["path", "None"]),
    (lambda s: s.write_data_set("x", 3), ["cameras", "3"]),
    (lambda s: s.save(None), ["path", "None", "os.PathLike"]),
    (lambda s: s.export("x.xml", collision=3), ["collision", "3"]),
    (lambda s: s.export("x.xml", meshes=3), ["meshes", "3"]),
    (lambda s: box().colored("red"), ["rgba", "red"]),
    (lambda s: box().colored([1, 1, NAN]), ["rgba", "nan"]),
    (lambda s: box().colored([[1], [1, 2]]), ["rgba", "3 or 4"]),
    (lambda s: follow(s, "push", [[1], [1, 2]]), ["goal", "2 or 3"]),
    (lambda s: follow(s, "translate", [1, 2]), ["goal", "3 finite"]),
    (lambda s: follow(s, "turn", [1, 2]), ["goal", "a number for 'turn'"]),
    (lambda s: trivet.random_rotation(3), ["rng", "3", "Generator"]),
    (lambda s: trivet.interpenetrations(3, 3), ["shapes", "3"]),
    (lambda s: trivet.Shape.load(None), ["path", "None"]),
    (lambda s: trivet.Scene.load("x.glb", progress=3), ["progress", "3"]),
    (lambda s: trivet.Scene.from_trimesh(None), ["scene", "NoneType", "trimesh.Scene"]),
    (lambda s: trivet.Scene.from_poses(3, [], []), ["names", "3"]),
    (lambda s: trivet.Scene.from_poses(["a"], [box()], [np.eye(4)], materials=3), ["materials", "3", "dict"]),
    (lambda s: trivet.Snapshot.from_bytes("x"), ["data", "x", "bytes"]),
]
BAD_CALLS += UNSEEN + NO_PYTHON_ERRORS


@pytest.mark.parametrize("number", range(len(BAD_CALLS)))
def test_arguments_that_are_not_accepted(number):
    call, says = BAD_CALLS[number]
    scene = table_with_cup()
    before = scene.fingerprint
    with pytest.raises(trivet.BadInputError) as caught:
        call(scene)
    for part in says:
        assert part in str(caught.value), str(caught.value)
    assert scene.fingerprint == before


def test_names_that_are_taken_or_unknown():
    scene = table_with_cup()
    for make in (lambda name: scene.add(name, box()), scene["cup"].rename, scene["cup"].duplicate):
        with pytest.raises(trivet.Refused) as caught:
            make("table")
        assert caught.value.code == "name_taken" and len(scene) == 2
        for name in ("floor", "", "a\0b", "a\nb", "\ud800", 5):
            with pytest.raises(trivet.BadInputError, match="accepted|no name"):
                make(name)
            assert scene.names == ["table", "cup"]
    for name in ("Cup", 5, None):
        with pytest.raises(trivet.NoSuchObject, match=str(name)):
            scene[name]
    with pytest.raises(trivet.NoSuchObject, match="ud800"):
        scene["\ud800"]
    assert "\ud800" not in scene
    assert issubclass(trivet.NoSuchObject, KeyError) and "nothing" not in scene and 5 not in scene
    with pytest.raises(TypeError, match="speed"):
        scene["cup"].push([1, 0], 0.1, speed=3)
    with pytest.raises(trivet.Refused) as caught:
        scene["cup"].put(on="tble")
    assert caught.value.code == "unknown_object" and "table" in str(caught.value)


@pytest.mark.parametrize("use", [
    lambda s, o: s["cup"].put(on=o), lambda s, o: s["cup"].push([1, 0], 0.1, together=[o]),
    lambda s, o: s["cup"].turn(5, with_=o), lambda s, o: s.drag(o), lambda s, o: s.view(highlight=[o]),
    lambda s, o: s.render(size=(8, 8), samples=1, highlight={o: [1, 0, 0, 1]}), lambda s, o: s.labels(classes={o: "x"})])
def test_objects_of_other_scenes_and_of_the_past(use):
    scene, other = table_with_cup(), table_with_cup()
    before = scene.fingerprint
    with pytest.raises(trivet.BadInputError, match='"table" of another scene.*accepted'):
        use(scene, other["table"])
    gone = scene.add("gone", box())
    gone.remove()
    scene.add("gone", box())  # another one of this name
    with pytest.raises(trivet.NoSuchObject, match="gone"):
        use(scene, gone)
    scene["gone"].remove()
    assert scene.fingerprint == before


def test_numbers_of_numpy_are_numbers():
    scene = table_with_cup()
    scene.perform([{"op": "push", "object": "cup", "direction": np.float32([1, 0]), "distance": np.float32(0.25),
                    "settle": np.bool_(True)},
                   {"op": "put", "object": "cup", "on": "table", "at": "anywhere", "seed": np.int64(4)}])
    scene["cup"].put(on="table", at=np.zeros(2), keep=np.float64(0.01), seed=np.uint8(3), settle_left=np.bool_(False))
    scene["cup"].material = {"friction": np.float32(0.5), "density": np.longdouble(700)}
    assert scene["cup"].material["friction"] == 0.5 and scene["cup"].material["density"] == 700
    scene.settle.max_motions = np.int32(7)
    assert scene.settle.max_motions == 7 and "max_motions=7" in repr(scene.settle)


def test_files_that_cannot_be_written(tmp_path):
    scene = table_with_cup()
    with scene.film() as film:
        scene["cup"].put([0.1, 0.2, 1])
    for save in (scene.view().save, film.save):
        with pytest.raises(trivet.EnvironmentFailure, match="missing.*x.glb"):
            save(tmp_path / "missing" / "x.glb")
    scene.save(tmp_path / "made" / "x.glb")  # a scene makes its folder
    assert trivet.Scene.load(tmp_path / "made" / "x.glb").names == scene.names


def test_stale_objects():
    scene = table_with_cup()
    cup = scene["cup"]
    cup.remove()
    other = scene.add("mug", box())  # perhaps in the slot of the cup
    for use in (lambda: cup.pose, lambda: cup.put([0, 0, 1]), lambda: cup.supports, lambda: cup.remove(),
                lambda: cup.duplicate("x"), lambda: cup.loads()):
        with pytest.raises(trivet.NoSuchObject, match="cup"):
            use()
    assert cup not in scene and other in scene
    again = scene.add("cup", box())
    assert again != cup
    with pytest.raises(trivet.NoSuchObject):
        cup.state


def test_refusals_name_the_cause():
    scene = table_with_cup()
    with pytest.raises(trivet.Refused) as caught:
        scene.add("in it", box(), pose=at(0, 0, 0.1))
    assert caught.value.code == "crossing" and caught.value.objects == ("in it", "table") and len(scene) == 2
    assert set(trivet.CAUSES) >= {"crossing", "wedged", "no_free_place", "not_tried"} and "" not in trivet.CAUSES


def test_exceptions_in_transactions_and_queries_leave_the_scene():
    scene = table_with_cup()
    before = scene.fingerprint
    with pytest.raises(ZeroDivisionError):
        with scene.transaction():
            scene["cup"].put([0.2, 0.2, 1])
            with pytest.raises(trivet.SceneBusy, match="transaction"):
                scene.undo()
            1 / 0
    assert scene.fingerprint == before
    with scene.transaction():
        with scene.transaction():
            scene["cup"].put([0.2, 0.2, 1])
        scene["cup"].put([0.3, 0.3, 1])
    assert scene.undo() and scene.fingerprint == before


def test_shapes_of_degenerate_faces_do_not_crash():
    flat = trivet.Shape(np.zeros((3, 3)), [[0, 1, 2]])
    assert flat.volume == 0 and len(flat.faces) == 1
    scene = trivet.Scene()
    result = scene.add("point", flat).try_put([0, 0, 1])
    assert result or result.code in trivet.CAUSES
