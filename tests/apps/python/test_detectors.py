"""Scene(detector=..., device=...): the same poses by every detector, in threads, and after fork and spawn."""
import functools
import multiprocessing
import os
import pickle
import subprocess
import sys
import textwrap
import threading
import warnings

import pytest

import trivet
from shapes import box, torus

FOLDER = os.path.dirname(os.path.abspath(__file__))
DETECTORS = ("auto", "bvh", "software", "gpu", "framebuffer", "compute")


def laid_out(detector):
    """Poses of a small heap, and whether a GPU was missing."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        scene = trivet.Scene(detector=detector)
        assert scene.detector == detector
        scene.add("slab", box(0.4, 0.4, 0.05), fixed=True, pose=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1]])
        ring = torus(16, 8)
        for i in range(2):
            scene.add(f"ring{i}", ring).put([0.02 * i, 0.01, 0.4 + 0.2 * i], [1, 0.2 * i, 0.1, 0])
        scene.add("cube", box(0.04, 0.04, 0.04)).put([-0.1, 0.1, 0.5], [1, 0.1, 0.2, 0.3])
        scene["cube"].push([1, 0.2], 0.02)
    assert len(told) <= 1
    return [one.pose.tobytes() for one in scene], [str(one.message) for one in told]


@functools.lru_cache(maxsize=None)
def truth():
    return laid_out("bvh")[0]


@pytest.mark.parametrize("detector", DETECTORS)
def test_every_detector_gives_the_same_poses(detector):
    poses, told = laid_out(detector)
    assert poses == truth()
    if detector in ("auto", "bvh", "software"):
        assert told == []


def test_choices_are_checked_and_can_be_changed():
    scene = trivet.Scene()
    assert (scene.detector, scene.device) == ("auto", "auto")
    scene.detector = "software"
    assert scene.detector == "software"
    for name in ("GPU", "", "raster"):
        with pytest.raises(trivet.BadInputError, match="accepted: auto, bvh, software, gpu, framebuffer, compute"):
            scene.detector = name
        with pytest.raises(trivet.BadInputError):
            trivet.Scene(detector=name)
    with pytest.raises(trivet.BadInputError):
        scene.detector = 3
    for device in (0, -1, 1.5, "one", None):
        with pytest.raises(trivet.BadInputError):
            scene.device = device
    assert scene.detector == "software"
    scene.device = 1
    assert scene.device == 1
    assert pickle.loads(pickle.dumps(scene)).detector == "software"


def test_layouts_are_run_by_the_detector(tmp_path):
    path = str(tmp_path / "scene.glb")
    scene = trivet.Scene()
    scene.add("cube", box(0.1, 0.1, 0.1)).put([0, 0, 1])
    scene.save(path)
    assert trivet.Scene.load(path, detector="software").detector == "software"


def test_threads_have_detectors_of_their_own():
    found = {}

    def work(number):
        found[number] = laid_out(("compute", "framebuffer", "software", "bvh")[number % 4])[0]

    threads = [threading.Thread(target=work, args=(number,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [found[number] for number in range(6)] == [truth()] * 6


def spawned(detector):
    return laid_out(detector)[0]


def test_spawned_processes():
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        assert pool.map(spawned, ["compute", "framebuffer"]) == [truth()] * 2


SCRIPT = """
    import os, sys, warnings
    sys.path.insert(0, {folder!r})
    from test_detectors import laid_out, truth
    used = {used}
    if used:
        assert laid_out("compute")[0] == truth()
    for _ in range(2):
        child = os.fork()
        if child == 0:
            poses, told = laid_out("compute")
            # OpenGL does not survive a fork: BVHs answer, and a warning says so.
            ok = poses == truth() and len(told) <= (1 if used else 0 if {has_gpu} else 1)
            os._exit(0 if ok else 1)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
    assert laid_out("compute")[0] == truth()
    print("done")
"""


@pytest.mark.parametrize("used", [False, True])
def test_after_a_fork(used):
    has_gpu = laid_out("compute")[1] == []
    script = textwrap.dedent(SCRIPT.format(folder=FOLDER, used=used, has_gpu=has_gpu))
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300)
    assert done.stdout == "done\n", done.stderr
