"""Pictures and labelled images: those of the program, and right by brute force."""
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from label_files import read_exr, read_png  # noqa: E402
from textured_boxes import textured_box_obj  # noqa: E402

import trivet  # noqa: E402
from shapes import at, box, box_arrays, table_with_cup, torus_arrays  # noqa: E402
from test_threads import others_run_during  # noqa: E402

PROGRAM = os.environ.get("TRIVET_PROGRAM")
needs_program = pytest.mark.skipif(not PROGRAM, reason="TRIVET_PROGRAM is not set")
SIZE = (96, 64)
EYE, TARGET, FOV = (0.3, -0.9, 0.5), (0, 0, 0.05), 40.0


def write_obj(path, vertices, faces):
    path.write_text("".join("v %r %r %r\n" % tuple(v) for v in np.asarray(vertices).tolist())
                    + "".join("f %d %d %d\n" % tuple(f + 1) for f in faces))


@pytest.fixture
def scene_file(tmp_path):
    """A saved scene with classes: a slab, a ring and a small ring that leans on it, and one out of the scene."""
    write_obj(tmp_path / "slab.obj", *box_arrays(0.5, 0.5, 0.05))
    write_obj(tmp_path / "ring.obj", *torus_arrays(24, 10))
    layout = {"trivet": 1, "objects": [
        {"name": "slab", "model": "slab.obj", "fixed": True, "position": [0, 0, 0.06]},
        {"name": "ring", "model": "ring.obj", "class": "bracelet"}, {"name": "small", "model": "ring.obj", "scale": 0.6},
        {"name": "out", "model": "ring.obj"}],
        "operations": [{"op": "put", "object": "ring", "position": [0.1, 0.05, 1.0]},
                       {"op": "put", "object": "small", "position": [0.22, 0.02, 1.5]}]}
    (tmp_path / "layout.json").write_text(json.dumps(layout))
    program("run", "layout.json", "-o", "scene.glb", folder=tmp_path)
    return tmp_path / "scene.glb"


def program(*arguments, folder):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, text=True, timeout=300)
    assert done.returncode in (0, 1), done.stderr


def pixels(path):
    width, height, channels, values = read_png(path.read_bytes())
    array = np.array(values).reshape(height, width, channels)
    return array[:, :, 0] if channels == 1 else array


def aimed():
    return trivet.Camera.look_at(EYE, TARGET, fov=FOV, size=SIZE)


AIMED = ("--width", SIZE[0], "--height", SIZE[1], "--camera", *EYE, *TARGET, "--fov", FOV)


@needs_program
def test_pictures_have_the_pixels_of_the_program(scene_file):
    folder = scene_file.parent
    program("render", "scene.glb", "-o", "aimed.png", "--renderer", "path", "--samples", 4, *AIMED, folder=folder)
    program("render", "scene.glb", "-o", "all.png", "--renderer", "path", "--bounces", 1, "--width", 80, "--height", 60,
            folder=folder)
    scene = trivet.Scene.load(scene_file)
    picture = scene.render(aimed(), samples=4)
    assert picture.shape == (64, 96, 3) and picture.dtype == np.uint8 and picture.flags.c_contiguous
    assert (picture == pixels(folder / "aimed.png")).all()
    assert (scene.render(size=(80, 60), bounces=1) == pixels(folder / "all.png")).all()


@needs_program
def test_labels_are_those_of_the_program(scene_file):
    folder = scene_file.parent
    program("render", "scene.glb", *AIMED, "--ids", "i.png", "--classes", "c.png", "--boxes", "b.json", "--visibility",
            folder=folder)
    scene = trivet.Scene.load(scene_file)
    labels = scene.labels(aimed())
    told = json.loads((folder / "b.json").read_text())
    assert (labels.instances == pixels(folder / "i.png")).all() and (labels.classes == pixels(folder / "c.png")).all()
    assert labels.names == tuple(o["name"] for o in told["objects"]) == ("slab", "ring", "small")
    assert labels.class_names == tuple(c["name"] for c in told["classes"]) == ("bracelet", "ring", "slab")
    assert labels.intrinsics.tolist() == told["camera"]["K"]
    assert labels.camera_from_world.tolist() == told["camera"]["camera_from_world"]
    for i, one in enumerate(told["objects"]):
        assert labels.class_ids[i] == one["class_id"]
        assert labels.boxes_visible[i].tolist() == one["box_visible"]
        assert labels.boxes_whole[i].tolist() == one["box_whole"]
        assert (labels.pixels_visible[i], labels.pixels_alone[i]) == (one["pixels_visible"], one["pixels_alone"])
        assert labels.visible_share[i] == one["visible_share"]


@needs_program
def test_depth_and_normals_are_those_of_the_program(scene_file):
    folder = scene_file.parent
    try:
        program("render", "scene.glb", *AIMED, "--depth", "d.exr", "--normals", "n.exr", folder=folder)
    except AssertionError as error:
        if "OpenEXR" in str(error):
            pytest.skip("the program was built without OpenEXR")
        raise
    labels = trivet.Scene.load(scene_file).labels(aimed())
    normals = read_exr((folder / "n.exr").read_bytes())
    assert labels.depth.ravel().tolist() == read_exr((folder / "d.exr").read_bytes())["Z"]
    for k, axis in enumerate("XYZ"):
        assert labels.normals[:, :, k].ravel().tolist() == normals[axis]


@needs_program
def test_domes_and_cameras_of_files_are_those_of_the_program(scene_file):
    folder = scene_file.parent
    program("render", "scene.glb", "--width", 96, "--height", 64, "--dome", 3, "--dome-seed", 7, "--dome-elevation", -20,
            60, "--boxes", "b{}.json", folder=folder)
    scene = trivet.Scene.load(scene_file)
    cameras = scene.dome(3, seed=7, elevation=(-20, 60), size=SIZE)
    for i, camera in enumerate(cameras):
        told = json.loads((folder / f"b{i:06d}.json").read_text())["camera"]
        assert camera.camera_from_world.tolist() == told["camera_from_world"] and camera.intrinsics.tolist() == told["K"]
        again = trivet.Camera.from_matrix(told["camera_from_world"], told["K"], (told["width"], told["height"]))
        assert again.eye == pytest.approx(camera.eye) and again.size == camera.size == SIZE
    assert scene.dome(2, seed=7, elevation=(-20, 60), size=SIZE) == cameras[:2] and scene.dome(3, size=SIZE) != cameras


def test_labels_are_consistent_with_each_other_and_the_scene():
    names, cup = ("table", "cup", "hidden"), table_with_cup()["cup"]  # one is within the table, which is closed
    scene = trivet.Scene.from_poses(names, [box(0.5, 0.5, 0.05), cup.shape, box(0.01, 0.01, 0.01)],
                                    [at(0, 0, 0.05 + 2e-6), cup.pose, at(0, 0, 0.02)])
    camera = scene.dome(1, seed=3, size=(160, 120))[0]
    labels = scene.labels(camera, classes={"cup": "vessel"})
    assert labels.class_names == ("hidden", "table", "vessel") and labels.classes[labels.mask("cup")].max() == 3
    assert labels.names == names and set(np.unique(labels.instances)) <= {0, 1, 2, trivet.FLOOR}
    points = labels.points()
    assert np.isnan(points[labels.instances == 0]).all() and np.abs(points[labels.mask("floor")][:, 2]).max() < 1e-5
    for i, name in enumerate(labels.names):
        one, mask = scene[name], labels.mask(name)
        assert labels.pixels_visible[i] == mask.sum() <= labels.pixels_alone[i]
        corners, depth = camera.project(one.shape.vertices @ one.matrix[:3, :3].T + one.matrix[:3, 3])
        lower, upper = corners.min(0) + 0.5, corners.max(0) + 0.5
        assert labels.boxes_whole[i] == pytest.approx([*lower, *(upper - lower)], abs=1e-9)
        if name == "hidden":
            assert np.isnan(labels.boxes_visible[i]).all() and labels.visible_share[i] == 0
            continue
        rows, columns = np.nonzero(mask)
        assert labels.boxes_visible[i].tolist() == [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
        assert labels.depth[mask].min() >= depth.min() - 1e-6 and labels.depth[mask].max() <= depth.max() + 1e-6
        low, high = one.bounds
        assert (points[mask] > low - 1e-5).all() and (points[mask] < high + 1e-5).all()
    normals = labels.normals[labels.instances > 0]
    assert np.linalg.norm(normals, axis=1) == pytest.approx(np.ones(len(normals)), abs=1e-6)
    bare = scene.labels(camera, normals=False, visibility=False, num_threads=1)
    assert bare.normals is None and not bare.visible_share.any() and (bare.depth == labels.depth).all()
    again = pickle.loads(pickle.dumps(labels))
    assert again.camera == camera and (again.points() == points)[labels.instances > 0].all()


def test_cameras_are_of_the_convention_of_opencv():
    camera = trivet.Camera.look_at((0, -2, 0), (0, 0, 0), fov=90, size=(101, 101))
    assert camera.intrinsics.tolist() == [[50.5, 0, 50], [0, 50.5, 50], [0, 0, 1]]
    pixels, depth = camera.project([[0, 0, 0], [1, 0, 0], [0, 0, 1], [0, -3, 0]])
    assert depth.tolist() == [2, 2, 2, -1] and np.isnan(pixels[3]).all()
    assert pixels[:3].tolist() == [[50, 50], [75.25, 50], [50, 24.75]]  # x to the right, y down
    assert camera.world_from_camera @ camera.camera_from_world == pytest.approx(np.eye(4))
    assert pickle.loads(pickle.dumps(camera)) == camera and len({camera, pickle.loads(pickle.dumps(camera))}) == 1
    again = trivet.Camera.from_matrix(camera.camera_from_world, camera.intrinsics, camera.size)
    assert again.project([[0.3, 0.1, 0.2]])[0] == pytest.approx(camera.project([[0.3, 0.1, 0.2]])[0])


def test_pictures_do_not_depend_on_threads_and_show_what_is_asked_for():
    scene = table_with_cup()
    camera = scene.camera(size=(64, 48))
    one = scene.render(camera, samples=2, num_threads=1)
    assert (one == scene.render(camera, samples=2, num_threads=5)).all() and one.std() > 10
    cup = scene.labels(camera).mask("cup")
    lit = scene.render(camera, samples=2, highlight=["cup"]).astype(int) - one
    assert (lit[cup][:, 0] - lit[cup][:, 2]).mean() > 30 and np.abs(lit[~cup]).mean() < 5
    blue = scene.render(camera, samples=2, highlight={scene["cup"]: (0, 0, 1, 1)})[cup].astype(int)
    assert (blue[:, 2] - blue[:, 0]).mean() > 30
    free = trivet.Scene(floor=False)
    free.add("b", box(), pose=at(0, 0, 0))
    picture = free.render(size=(64, 48), samples=2, transparent=True)
    assert picture.shape == (48, 64, 4) and picture[0, 0, 3] == 0 and picture[24, 32, 3] == 255
    assert (trivet.Scene().labels(size=(8, 6)).instances != 1).all()


def test_progress_goes_up_and_what_it_raises_stops_the_picture():
    scene = table_with_cup()
    told = []
    scene.render(size=(64, 48), samples=1, progress=told.append)
    assert told == sorted(told) and len(told) > 1 and told[-1] == 1

    def stop(fraction):
        raise ZeroDivisionError(fraction)

    begin = time.perf_counter()
    with pytest.raises(ZeroDivisionError):
        scene.render(size=(480, 270), samples=4096, progress=stop)  # minutes of work
    assert time.perf_counter() - begin < 30


def test_ctrl_c_stops_a_picture():
    scene = table_with_cup()
    before = scene.fingerprint
    begin = time.perf_counter()
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        scene.render(size=(1920, 1080), samples=4096)  # an hour of work
    assert time.perf_counter() - begin < 10
    timer.join()
    assert scene.fingerprint == before and scene.render(size=(8, 8), samples=1).shape == (8, 8, 3)


def test_others_work_while_a_picture_is_made():
    """The GIL is free, and the scene may change: it is drawn as it was at the call."""
    scene = table_with_cup()
    camera = scene.camera(size=(320, 240))
    wanted = scene.render(camera, samples=8)
    made, began, changed = [], threading.Event(), threading.Event()

    def told(fraction):
        began.set()
        assert changed.wait(60)

    thread = threading.Thread(target=lambda: made.append(scene.render(camera, samples=8, progress=told)))
    thread.start()
    assert began.wait(60)
    scene["cup"].translate([0, 0, 0.3], free=True)
    changed.set()
    thread.join()
    assert (made[0] == wanted).all() and (scene.render(camera, samples=8) != wanted).any()
    assert others_run_during(lambda: scene.render(camera, samples=8))


def film_of(glb):
    """The only animation of a .glb: (object, path): values of all keys."""
    size = int.from_bytes(glb[12:16], "little")
    scene, binary = json.loads(glb[20:20 + size]), glb[28 + size:]
    out = {}
    for channel in scene["animations"][0]["channels"]:
        accessor = scene["accessors"][scene["animations"][0]["samplers"][channel["sampler"]]["output"]]
        begin = scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
        width = {"VEC3": 3, "VEC4": 4}[accessor["type"]]
        values = np.frombuffer(binary, np.float32, accessor["count"] * width, begin).reshape(-1, width)
        out[scene["nodes"][channel["target"]["node"]]["name"], channel["target"]["path"]] = values
    return out


def test_textures_are_decoded_once_for_all_pictures_of_a_scene(tmp_path):
    (tmp_path / "carton.obj").write_text(textured_box_obj(0.1, 0.1, 0.1))
    (tmp_path / "carton.mtl").write_text("newmtl paper\nmap_Kd carton.png\n")
    noise = np.random.default_rng(1).integers(0, 256, (1500, 1500, 3), dtype=np.uint8)
    (tmp_path / "carton.png").write_bytes(trivet.encode_png(noise))
    scene = trivet.Scene()
    carton = scene.add("carton", trivet.Shape.load(tmp_path / "carton.obj"), pose=at(0, 0, 0.1001))
    camera = scene.camera((16, 12))

    def picture():
        begin = time.process_time()
        pixels = scene.render(camera, samples=1)
        return pixels, time.process_time() - begin

    first, long = picture()
    again = [picture() for _ in range(3)]
    assert all((pixels == first).all() for pixels, _ in again)
    assert min(seconds for _, seconds in again) < 0.5 * long
    carton.translate([0.1, 0.0, 0.0])
    assert (picture()[0] != first).any() and scene.labels(camera).names == ("carton",)


def test_films_show_what_moved(tmp_path):
    scene = table_with_cup()
    with scene.film() as film:
        with pytest.raises(trivet.SceneBusy, match="already"):
            with scene.film():
                pass
        with pytest.raises(trivet.SceneBusy, match="after its block"):
            film.to_glb()
        scene.add("ball", box(0.03, 0.03, 0.03)).put([-0.2, 0, 1.0])
        scene["table"].fixed = False
        carried = scene["table"].push([1, 0], 0.3).carried
        scene.undo()
        with pytest.raises(trivet.Refused):
            scene["ball"].put([-0.2, 0, 0.05])
    assert set(carried) == {"ball", "cup"} and film.seconds > 1
    film.save(tmp_path / "film.glb")
    moved = film_of((tmp_path / "film.glb").read_bytes())
    assert {name for name, _ in moved} == {"table", "cup", "ball"} and ("ball", "scale") in moved
    ball = moved["ball", "translation"]
    assert ball[1].tolist() == pytest.approx([-0.2, 1, 0], abs=1e-6)  # y up; before, it was hidden
    for name in ("table", "cup", "ball"):  # undone: where they were
        x, y, z = scene[name].position
        assert moved[name, "translation"][-1].tolist() == pytest.approx([x, z, -y], abs=1e-5)
    assert moved["table", "translation"][:, 0].max() == pytest.approx(0.3, abs=1e-3)
    apart = moved["cup", "translation"][:, 0].max() - moved["cup", "translation"][:, 0].min()
    assert apart == pytest.approx(0.3, abs=1e-3)
    with scene.film() as still:
        pass
    assert len(still.to_glb()) > 100


@pytest.mark.parametrize("options, says", [
    (dict(size=(0, 10)), ["size", "(0, 10)", "16384"]),
    (dict(size=(10, 16385)), ["size", "16385"]),
    (dict(size=(16384, 16384)), ["size", "67108864"]),
    (dict(size=(10.5, 10)), ["size", "10.5"]),
    (dict(size=10), ["size", "(width, height)"]),
    (dict(size="ab"), ["size", "'ab'"]),
    (dict(samples=0), ["samples", "0", "4096"]),
    (dict(samples=1.5), ["samples", "1.5", "whole"]),
    (dict(samples=2 ** 70), ["samples", "4096"]),
    (dict(bounces=65), ["bounces", "64"]),
    (dict(num_threads=-1), ["num_threads", "-1"]),
    (dict(camera="front"), ["camera", "'front'", "look_at"]),
    (dict(highlight="cup"), ["highlight", "'cup'"]),
    (dict(highlight={"cup": (1, 0, 0, 2)}), ["highlight", "0 to 1"]),
])
def test_pictures_that_cannot_be(options, says):
    with pytest.raises(trivet.BadInputError) as caught:
        table_with_cup().render(**options)
    for part in says:
        assert part in str(caught.value), str(caught.value)


def test_other_bad_input():
    scene = table_with_cup()
    look_at, eye = trivet.Camera.look_at, np.eye(4)
    for call in (lambda: look_at((0, 0, 0), (0, 0, 0)), lambda: look_at((0, 0, np.nan)), lambda: look_at((1, 0, 0), fov=180),
                 lambda: trivet.Camera.from_matrix(2 * eye, np.eye(3), (8, 8)),
                 lambda: trivet.Camera.from_matrix(eye, np.ones((3, 3)), (8, 8)),
                 lambda: trivet.Camera.from_matrix(eye, np.diag([-1, 1, 1]), (8, 8)),
                 lambda: trivet.Camera.from_matrix(eye[:3], np.eye(3), (8, 8)),
                 lambda: trivet.Camera.from_matrix(np.ones((4, 4)), np.eye(3), (8, 8)),
                 lambda: scene.dome(0), lambda: scene.dome(1, elevation=(50, 20)), lambda: scene.dome(1, radius=-1),
                 lambda: scene.dome(1, seed=-1), lambda: scene.dome(1, fov=0), lambda: scene.camera((0, 0)),
                 lambda: scene.labels(classes={"cup": ""}), lambda: scene.labels(classes={"cup": 3}),
                 lambda: scene.render(aimed(), size=(10, 10))):
        with pytest.raises(trivet.BadInputError):
            call()
    for call in (lambda: scene.render(size=(8, 8), highlight=["spoon"]), lambda: scene.labels(classes={"spoon": "x"}),
                 lambda: scene.labels(size=(8, 8)).mask("spoon")):
        with pytest.raises(trivet.NoSuchObject, match="spoon"):
            call()
    with pytest.raises(TypeError, match="look_at"):
        trivet.Camera()
