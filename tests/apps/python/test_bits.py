"""The same bits as the program; values that are kept, pickled and saved."""
import json
import os
import pickle
import subprocess

import numpy as np
import pytest

import trivet
from shapes import at, box, box_arrays, table_with_cup, torus_arrays

PROGRAM = os.environ.get("TRIVET_PROGRAM")


def write_obj(path, vertices, faces):
    path.write_text("".join("v %r %r %r\n" % tuple(v) for v in np.asarray(vertices).tolist())
                    + "".join("f %d %d %d\n" % tuple(f + 1) for f in faces))


def layout_of(folder):
    write_obj(folder / "slab.obj", *box_arrays(0.5, 0.5, 0.05))
    write_obj(folder / "ring.obj", *torus_arrays(24, 10))
    write_obj(folder / "stick.obj", *box_arrays(0.01, 0.01, 0.2))
    operations = [
        {"op": "put", "object": "ring", "position": [0.1, 0.05, 1.0], "rotation": [0.9, 0.3, 0.1, 0.3]},
        {"op": "put", "object": "stick", "position": [0.12, 0.02, 1.5], "rotation": [0.7, 0.1, 0.7, 0.1]},
        {"op": "put", "object": "ring2", "on": "slab", "at": "anywhere", "seed": 5, "keep": 0.01},
        {"op": "push", "object": "ring", "direction": [1, 0.5], "distance": 0.1},
        {"op": "turn", "object": "ring", "angle_deg": 33},
    ]
    objects = [{"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.06]},
               {"name": "ring", "model": "ring.obj"}, {"name": "ring2", "model": "ring.obj", "scale": 0.5},
               {"name": "stick", "model": "stick.obj", "material": "wood"}]
    layout = {"trivet": 1, "objects": objects, "operations": operations}
    (folder / "layout.json").write_text(json.dumps(layout))
    return layout


@pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")
def test_a_layout_gives_the_bits_of_the_program(tmp_path):
    layout = layout_of(tmp_path)
    subprocess.run([PROGRAM, "run", "layout.json", "-o", "scene.glb", "--report", "report.json"], cwd=tmp_path,
                   check=False, capture_output=True, timeout=120)
    report = {o["name"]: o for o in json.loads((tmp_path / "report.json").read_text())["objects"]}

    by_file = trivet.Scene.load(tmp_path / "layout.json")
    by_calls = trivet.Scene()
    shapes = {name: trivet.Shape.load(tmp_path / name) for name in ("slab.obj", "ring.obj", "stick.obj")}
    for o in layout["objects"]:
        pose = at(*o["position"]) if "position" in o else None
        by_calls.add(o["name"], shapes[o["model"]], pose=pose, fixed=o.get("fixed", False), scale=o.get("scale", 1),
                     material=o.get("material"))
    ring, stick, ring2 = by_calls["ring"], by_calls["stick"], by_calls["ring2"]
    ring.put([0.1, 0.05, 1.0], [0.9, 0.3, 0.1, 0.3])
    stick.put([0.12, 0.02, 1.5], [0.7, 0.1, 0.7, 0.1])
    ring2.put(on="slab", at="anywhere", seed=5, keep=0.01)
    ring.push([1, 0.5], 0.1)
    ring.turn(33)
    for scene in (by_file, by_calls, trivet.Scene.load(tmp_path / "scene.glb")):
        for o in scene:
            assert o.matrix.ravel().tolist() == report[o.name]["world_from_file"], o.name
            assert o.state == report[o.name]["state"]


def export_by_program(scene, output, *options):
    """The program's report on what it exports of a saved scene, and its status."""
    scene.save(output.parent / "scene.glb")
    done = subprocess.run([PROGRAM, "export", "scene.glb", "-o", output.name, "--json", *map(str, options)],
                          cwd=output.parent, capture_output=True, text=True, timeout=120)
    return (json.loads(done.stdout) if done.stdout else done.stderr), done.returncode


def exported_files(folder, files):
    names = [os.path.relpath(folder / one, folder) for one in files]
    return {name: (folder / name).read_bytes() for name in names}


@pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")
@pytest.mark.parametrize("name", ["scene.xml", "scene.mjcf", "scene.urdf", "scene.sdf", "scene.usda"])
@pytest.mark.parametrize("options", [{}, {"collision": "components", "friction": 0.6, "density": 800}])
def test_exports_are_those_of_the_program(name, options, tmp_path):
    scene = table_with_cup()
    scene.add("a stick", box(0.02, 0.03, 0.1), material="wood").put([-0.3, -0.2, 1])
    report, status = export_by_program(scene, tmp_path / name, *(x for k, v in options.items() for x in ("--" + k, v)))
    assert status == 0, report
    done = scene.export(tmp_path / "here" / name, **options)
    here, there = exported_files(tmp_path / "here", done.files), exported_files(tmp_path, report["files"])
    assert sorted(here) == sorted(there) and name in here and len(here) > 1
    assert [one for one in here if here[one] != there[one]] == []
    assert done.masses == {one["name"]: one["mass"] for one in report["objects"]}
    assert list(done.notes) == report["notes"]


def test_exports_share_meshes(tmp_path):
    scene = table_with_cup()
    done = [scene.export(tmp_path / name, meshes="shared") for name in ("a.urdf", "b.urdf")]
    meshes = [sorted(os.path.basename(file) for file in one.files[1:]) for one in done]
    assert meshes[0] == meshes[1] == sorted(os.listdir(tmp_path / "shared")) and meshes[0]
    assert all(("shared/" + name) in (tmp_path / "b.urdf").read_text() for name in meshes[0] if name.endswith(".obj"))
    thin = scene.export(tmp_path / "c.urdf", hull_clearance=1e-3)
    assert {os.path.basename(file) for file in thin.files[1:]} - set(meshes[0])


@pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")
def test_mujoco_moves_what_is_not_at_rest_only(tmp_path):
    scene = trivet.Scene.from_poses(["lies", "hangs"], [box()] * 2, [at(0, 0, 0.05 + 1e-6), at(1, 0, 0.5)])
    for one, falls in ((table_with_cup(), []), (scene, ["hangs"])):
        report, status = export_by_program(one, tmp_path / "scene.xml", "--simulate", 1, "--collision", "components")
        if "MuJoCo" in report or "libmujoco" in report:
            pytest.skip(f"trivet export --simulate: {report.strip()}")
        done = one.export(tmp_path / "here" / "scene.xml", collision="components")
        assert exported_files(tmp_path / "here", done.files) == exported_files(tmp_path, report["files"])  # it ran these
        moved = [o["name"] for o in report["simulated"]["objects"] if o["moved"] > 1e-3]
        assert moved == falls and status == len(falls) and report["simulated"]["warnings"] == 0


def test_a_layout_of_pieces_is_one_step():
    scene = trivet.Scene()
    scene.add("a", box())
    scene.add("b", box())
    before = scene.fingerprint
    with pytest.raises(trivet.Refused) as caught:
        scene.perform([{"op": "put", "object": "a", "position": [0, 0, 1]},
                       {"op": "put", "object": "b", "position": [0, 0, 0.05]}])
    assert caught.value.code == "crossing" and scene.fingerprint == before
    scene.perform([{"op": "put", "object": "a", "position": [0, 0, 1]}, {"op": "put", "object": "b", "on": "a"}])
    assert scene["b"].supports == [scene["a"]]
    assert scene.undo() and scene.fingerprint == before


def test_shapes_pickle():
    shape = trivet.Shape(*torus_arrays(30, 20))
    buffers = []
    data = pickle.dumps(shape, protocol=5, buffer_callback=buffers.append)
    back = pickle.loads(data, buffers=buffers)
    assert (back.vertices == shape.vertices).all() and (back.faces == shape.faces).all()
    assert (back.vertex_map == shape.vertex_map).all() and back.volume == shape.volume
    assert len(data) < 2000 and len(buffers) >= 2  # the arrays go out of band
    assert (pickle.loads(pickle.dumps(shape)).faces == shape.faces).all()


def test_shapes_of_files_pickle_with_their_look(tmp_path):
    write_obj(tmp_path / "box.obj", *box_arrays(1, 2, 3))
    shape = trivet.Shape.load(tmp_path / "box.obj")
    back = pickle.loads(pickle.dumps(shape))
    assert (back.vertices == shape.vertices).all() and back.name == shape.name and back.up == shape.up


def test_scenes_and_snapshots_pickle():
    scene = table_with_cup()
    scene.add("out of the scene", box())
    back = pickle.loads(pickle.dumps(scene))
    assert back.names == scene.names
    assert [(o.state, o.fixed, o.scale) for o in back] == [(o.state, o.fixed, o.scale) for o in scene]
    for a, b in zip(back, scene):
        assert a.placed == b.placed and (not a.placed or (a.pose == b.pose).all())
        assert (a.shape.vertices == b.shape.vertices).all()
    snapshot = pickle.loads(pickle.dumps(scene.snapshot()))
    assert snapshot.fingerprint == scene.fingerprint == back.fingerprint
    assert pickle.loads(pickle.dumps(trivet.Scene())).names == []


def test_poses_without_shapes_are_enough_where_the_shapes_are():
    shapes = {f"ring {k}": trivet.Shape(*torus_arrays(20 + k, 10)) for k in range(6)}
    scene, random = trivet.Scene(), np.random.default_rng(11)
    for name, shape in shapes.items():
        ring = scene.add(name, shape)
        while not ring.try_put([*random.uniform(-.15, .15, 2), 1.0], wxyz=trivet.random_rotation(random)):
            pass
    sent = pickle.dumps([(one.name, one.position, one.wxyz) for one in scene])
    assert len(sent) < 200 * len(shapes)
    back = trivet.Scene()
    for name, position, wxyz in pickle.loads(sent):
        back.add(name, shapes[name]).stand(position, wxyz)
    assert all((a.pose == b.pose).all() and a.state == b.state for a, b in zip(scene, back))
    assert any(one.supports != ["floor"] for one in back)


def test_results_and_refusals_pickle():
    scene = trivet.Scene(floor=False)
    result = scene.add("a", box()).try_put([0, 0, 1])
    assert not result and pickle.loads(pickle.dumps(result)).code == "nothing_below"
    error = pickle.loads(pickle.dumps(trivet.Refused(result)))
    assert error.code == "nothing_below" and error.objects == ("a",) and str(error) == result.reason


def test_scenes_are_saved_and_read(tmp_path):
    scene = table_with_cup()
    scene.save(tmp_path / "scene.glb")
    assert (tmp_path / "scene.glb").read_bytes() == scene.to_glb()
    for back in (trivet.Scene.load(tmp_path / "scene.glb"), trivet.Scene.from_bytes(scene.to_glb())):
        assert back.fingerprint == scene.fingerprint and back.notes == []
        back["cup"].put([0.2, 0.2, 1])  # and goes on
        back.save(tmp_path / "again.glb")
        assert trivet.Scene.load(tmp_path / "again.glb").fingerprint == back.fingerprint
    for extension in (".obj", ".ply", ".stl", ".gltf"):
        scene.save(tmp_path / ("scene" + extension))
    with pytest.raises(trivet.BadInputError, match="accepted"):
        scene.save(tmp_path / "scene.txt")
    with pytest.raises(trivet.EnvironmentFailure):
        scene.save("/proc/no/scene.glb")


def test_rules_of_settling_are_kept(tmp_path):
    usual = trivet.Scene().settle
    other = dict(perfect_friction=not usual.perfect_friction, whole_at_rest=not usual.whole_at_rest,
                 robust=not usual.robust)
    scene = trivet.Scene(clearance=1e-5, **other)
    scene.add("a", box()).put([0, 0, 1])
    scene.save(tmp_path / "scene.glb")
    for back in (trivet.Scene.load(tmp_path / "scene.glb"), trivet.Scene.from_bytes(scene.to_glb()),
                 pickle.loads(pickle.dumps(scene)), scene.snapshot().scene()):
        assert {key: getattr(back.settle, key) for key in other} == other and back.settle.clearance == 1e-5
    asked = trivet.Scene.load(tmp_path / "scene.glb", whole_at_rest=usual.whole_at_rest)
    assert asked.settle.whole_at_rest == usual.whole_at_rest
    assert asked.settle.perfect_friction != usual.perfect_friction
    assert trivet.Scene.load(tmp_path / "scene.glb", robust=False).settle.robust is False


def test_refused_operations_of_layouts_are_warned_of(tmp_path):
    layout = layout_of(tmp_path)
    layout["operations"].append({"op": "put", "object": "stick", "on": "ring2", "keep": 9})
    (tmp_path / "layout.json").write_text(json.dumps(layout))
    with pytest.warns(trivet.TrivetWarning, match="stick.*refused"):
        trivet.Scene.load(tmp_path / "layout.json")


def test_progress_is_told_and_may_stop(tmp_path):
    layout_of(tmp_path)
    told = []
    trivet.Scene.load(tmp_path / "layout.json", progress=lambda *one: told.append(one))
    assert {stage for stage, *_ in told} >= {"load", "put"}
    assert all(0 <= done <= total for _, _, done, total in told)

    def stop(stage, item, done, total):
        raise LookupError(stage)

    with pytest.raises(LookupError, match="load"):
        trivet.Scene.load(tmp_path / "layout.json", progress=stop)


def test_arrays_of_all_kinds_are_the_same_shape():
    vertices, faces = torus_arrays(12, 8)
    wanted = trivet.Shape(vertices, faces)
    read_only = vertices.copy()
    read_only.flags.writeable = False
    for v, f in [(read_only, faces.astype(np.uint8)), (np.asfortranarray(vertices), np.asfortranarray(faces)),
                 (np.repeat(vertices, 2, axis=0)[::2], faces.astype(np.int64)), (vertices.tolist(), faces.tolist())]:
        shape = trivet.Shape(v, f)
        assert (shape.vertices == wanted.vertices).all() and (shape.faces == wanted.faces).all()
    given = vertices.copy()
    shape = trivet.Shape(given, faces)
    given[:] = 0  # a copy was taken
    assert (shape.vertices == wanted.vertices).all()
    with pytest.raises(ValueError):
        shape.vertices[0, 0] = 1
    view = shape.vertices
    del shape
    assert (view == wanted.vertices).all()


def test_vertices_merge_and_are_mapped():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5], [1, 0, 0], [0, 1, 0], [1, 1, 0]], float)
    shape = trivet.Shape(corners, [[0, 1, 2], [4, 6, 5]])
    assert len(shape.vertices) == 4 and shape.vertex_map[3] == -1
    used = shape.vertex_map >= 0
    assert (shape.vertices[shape.vertex_map[used]] == corners[used]).all()


def test_properties_tell_what_is():
    scene = trivet.Scene(floor_material={"friction": 0.3})
    shape = box(0.1, 0.1, 0.1).colored([1, 0, 0])
    one = scene.add("one", shape, scale=2, material="wood")
    assert not one.placed and one.pose is None and one.state == "unplaced" and one.bounds is None
    one.put([1, 2, 3])
    assert one.position[:2].tolist() == [1, 2] and one.pose[:3, 3].tolist() == one.position.tolist()
    assert one.matrix[0, 0] == 2 and one.pose[0, 0] == 1
    assert one.bounds[1, 2] == pytest.approx(0.4, abs=1e-4) and one.center_mass[2] == pytest.approx(0.2, abs=1e-4)
    density = trivet.materials()["wood"]["density"]
    assert one.weight == pytest.approx(0.4 ** 3 * density * 9.80665)
    assert one.supports == ["floor"] and one.margin == pytest.approx(0.2, abs=1e-4)
    one.material = {"friction": 0.4, "density": 700}
    assert one.material["friction"] == 0.4 and one.weight == pytest.approx(0.4 ** 3 * 700 * 9.80665)
    one.locked = True
    with pytest.raises(trivet.Refused, match="locked"):
        one.put([0, 0, 1])
    one.locked = False
    one.fixed = True
    assert one.fixed and one.state == "fixed"
    other = one.duplicate("other")
    assert other.material == one.material and other.shape == one.shape and not other.fixed
    other.put(on=one)
    assert scene.check().stable and "one" in scene._repr_html_() and repr(one) == "<trivet.Object 'one', fixed>"
    other.group = "pair"
    assert other.group == "pair"
    other.unplace()
    assert not other.placed
    assert "other" in scene and other in scene
    renamed = other.rename("another")
    assert renamed.name == "another" and renamed.group == "pair" and "other" not in scene
    with pytest.raises(trivet.Refused, match="one"):
        renamed.rename("one")
    assert scene.undo() and "another" not in scene and other.group == "pair"
    other.remove()
    assert "other" not in scene and repr(other) == "<trivet.Object 'other', deleted>"
    with pytest.raises(trivet.NoSuchObject):
        other.pose
    assert scene.undo() and not other.placed
