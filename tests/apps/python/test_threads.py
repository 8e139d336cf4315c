"""Threads, processes, Ctrl+C, and the end of the interpreter."""
import contextlib
import functools
import multiprocessing
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import pytest

import trivet
from shapes import SANITIZED, box, table_with_cup, torus

FOLDER = os.path.dirname(os.path.abspath(__file__))


@functools.lru_cache(maxsize=None)
def pile(around, across):
    """Three fine tori, one on the other, and a fourth to be put; by perfect friction, which holds any such pile."""
    scene = trivet.Scene(perfect_friction=True)
    shape = torus(around, across)
    for i in range(3):
        scene.add(f"t{i}", shape).put([0.02 * i, 0, 1], [1, 0.1 * i, 0.2, 0])
    scene.add("next", shape)
    return scene.snapshot()


def heavy_scene(around=160, across=80):
    """A scene and its object of which a put takes long, or at least has many motions."""
    scene = pile(around, across).scene()
    return scene, scene["next"]


def test_races_give_the_result_of_some_order():
    """8 threads put one box each onto one place: whoever comes first lies lowest."""
    for run in range(5):
        scene = trivet.Scene()
        shape = box()
        objects = [scene.add(f"b{i}", shape) for i in range(8)]
        start = threading.Barrier(8)
        errors = []

        def work(one):
            try:
                start.wait()
                one.put([0, 0, 5])
                one.push([1, 0.1], 0.001)
            except Exception as error:
                errors.append(error)

        threads = [threading.Thread(target=work, args=(one,)) for one in objects]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert errors == []
        heights = sorted(o.position[2] for o in scene)
        assert heights == pytest.approx([0.05 + 0.1 * k for k in range(8)], abs=1e-4)
        assert scene.check().ok and len(scene.steps) == 8 + 16
        again = trivet.Scene()
        for o in scene:
            again.add(o.name, shape)
        again.perform(steps_of(scene))
        assert [o.position.tolist() for o in again] == [o.position.tolist() for o in scene]


def steps_of(scene):
    """The operations of the race in the order in which they were done."""
    out = []
    for step in scene.steps[8:]:
        op, name = step.split(" ")[0], step.split('"')[1]
        if op == "put":
            out.append({"op": "put", "object": name, "position": [0, 0, 5]})
        else:
            out.append({"op": "push", "object": name, "direction": [1, 0.1], "distance": 0.001})
    return out


def test_threads_add_read_and_undo_at_once():
    scene = table_with_cup()
    shape = torus(12, 8)
    done = threading.Event()
    errors = []

    def guarded(work):
        def run():
            try:
                work()
            except Exception as error:
                errors.append(error)
                done.set()
        return threading.Thread(target=run)

    def write(k):
        for i in range(10):
            scene.add(f"w{k}_{i}", shape).try_put([0.1 * k - 0.2, 0.08 * i - 0.4, 1])

    def read():
        while not done.is_set():
            for o in scene:
                o.pose, o.supports, o.state
            scene.contacts(), scene.support_graph(), scene.snapshot().fingerprint, len(scene)

    def history():
        while not done.is_set():
            try:
                with scene.transaction():
                    scene["cup"].translate([0, 0, 0.01], free=True)
                    scene["cup"].put([0.1, 0.1, 1.0])
            except trivet.Refused:  # what others put may not stand with it
                pass
            time.sleep(0.002)

    readers = [guarded(read), guarded(read), guarded(history)]
    writers = [guarded(lambda k=k: write(k)) for k in range(5)]
    for thread in readers + writers:
        thread.start()
    for thread in writers:
        thread.join()
    done.set()
    for thread in readers:
        thread.join()
    assert errors == [] and len(scene) == 52
    while scene.undo():
        pass
    assert len(scene) == 0


def others_run_during(work, after=lambda: None):
    """@return whether another thread ran 5 times inside of one of 50 calls; once may be at its edge."""
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.wait(0.0005):
            ticks.append(time.perf_counter())

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        for _ in range(50):
            begin = time.perf_counter()
            work()
            end = time.perf_counter()
            if sum(begin < t < end for t in ticks) >= 5:
                return True
            after()
        return False
    finally:
        stop.set()
        thread.join()


def test_other_threads_run_during_a_put():
    scene, following = heavy_scene()
    assert others_run_during(lambda: following.put([0.01, 0.01, 1]), scene.undo)


def test_an_operation_is_cancelled_from_another_thread():
    scene, following = heavy_scene()
    before = scene.fingerprint
    caught = []

    def put():
        while not caught:  # a cancel before the beginning stops nothing
            try:
                following.put([0.01, 0.01, 1])
                scene.undo()
            except trivet.Cancelled as error:
                caught.append(error)

    thread = threading.Thread(target=put)
    thread.start()
    while thread.is_alive():
        time.sleep(0.002)
        scene.cancel()
    assert "cancelled" in str(caught[0]) and caught[0].code == "cancelled" and scene.fingerprint == before


def test_a_budget_ends_a_put():
    scene, following = heavy_scene()
    before = scene.fingerprint
    with pytest.raises(trivet.OutOfTime, match="did not end within") as caught:
        following.put([0.01, 0.01, 1], budget=1e-4)
    assert isinstance(caught.value, TimeoutError) and scene.fingerprint == before
    scene.time_budget = 1e-4
    with pytest.raises(trivet.OutOfTime):
        following.put([0.01, 0.01, 1])


@contextlib.contextmanager
def control_c_again_and_again():
    """Ctrl+C every 5 ms, with a handler that raises nothing: one that falls between two calls stops none.
    Gives the list of the signals that it got."""
    called, stop = [], threading.Event()

    def send():
        while not stop.wait(0.005):
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, lambda *_: called.append(1))
    thread = threading.Thread(target=send)
    thread.start()
    try:
        yield called
    finally:
        stop.set()
        thread.join()
        signal.signal(signal.SIGINT, before)


def test_control_c_with_a_handler_of_its_own():
    """A handler that does not raise: the put is cancelled all the same."""
    scene, following = heavy_scene()
    with control_c_again_and_again() as called:
        with pytest.raises(trivet.Cancelled):
            for _ in range(200):
                following.put([0.01, 0.01, 1])
                scene.undo()
    assert called and not following.placed


def run_script(text, timeout=120, **options):
    text = "import sys; sys.path.insert(0, %r)\n" % FOLDER + textwrap.dedent(text)
    return subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=timeout, **options)


def test_the_interpreter_may_end_in_the_middle_of_a_put():
    for _ in range(3):
        done = run_script("""
            import threading, time, trivet
            from test_threads import heavy_scene
            scene, following = heavy_scene()
            begun = threading.Event()
            def work():
                while True:
                    begun.set()
                    try:
                        following.put([0.01, 0.01, 1])
                        scene.undo()
                    except trivet.Cancelled:
                        pass
            for _ in range(3):
                threading.Thread(target=work, daemon=True).start()
            begun.wait()
            time.sleep(0.01)
            print("end")
        """)
        assert done.returncode == 0 and done.stdout == "end\n", done.stderr
        assert "terminate" not in done.stderr and "Fatal" not in done.stderr


def test_objects_may_outlive_what_they_belong_to():
    done = run_script("""
        import atexit, trivet
        from shapes import box, table_with_cup
        scene = table_with_cup()
        view = box().vertices
        cup = scene["cup"]
        del scene
        print(cup.state, view.shape)
        drag = cup.scene.drag("cup").__enter__()
        atexit.register(lambda: print("late", cup.state))
        keep = [cup, drag, trivet]
    """)
    assert done.returncode == 0 and done.stdout == "stable (8, 3)\nlate stable\n", done.stderr


def test_a_callback_may_not_use_the_scene_at_work(tmp_path):
    """Progress of a load has no scene yet; a second scene may be used from it."""
    from test_bits import layout_of

    layout_of(tmp_path)
    other = table_with_cup()
    seen = []
    trivet.Scene.load(tmp_path / "layout.json", progress=lambda *_: seen.append(other["cup"].state))
    assert set(seen) == {"stable"}


def child(queue):
    scene = table_with_cup()
    queue.put((scene.fingerprint, scene["cup"].pose.tobytes()))


@pytest.mark.parametrize("method", ["spawn", "fork", "forkserver"])
def test_processes_give_the_same_bits(method):
    context = multiprocessing.get_context(method)
    queue = context.Queue()
    process = context.Process(target=child, args=(queue,))
    process.start()
    there = queue.get(timeout=60)
    process.join()
    here = table_with_cup()
    assert there == (here.fingerprint, here["cup"].pose.tobytes())


def test_a_fork_in_the_middle_of_a_put_is_told():
    """The child's copy of a scene that another thread held is refused, and does not hang."""
    scene, following = heavy_scene()
    thread = threading.Thread(target=lambda: [following.try_put([0.01, 0.01, 1]) for _ in range(3)])
    with scene.transaction():
        thread.start()
        read_end, write_end = os.pipe()
        pid = os.fork()
        if pid == 0:
            try:
                helper = threading.Thread(target=lambda: other(scene, write_end))
                helper.start()
                helper.join()
            finally:
                os._exit(0)
    os.close(write_end)
    told = os.read(read_end, 100)
    os.waitpid(pid, 0)
    thread.join()
    assert told == b"busy"


def other(scene, pipe):
    try:
        scene.fingerprint
        os.write(pipe, b"read")
    except trivet.SceneBusy:
        os.write(pipe, b"busy")


@pytest.mark.skipif(SANITIZED, reason="the sanitizer gives no memory back")
def test_memory_stays_flat_over_many_scenes():
    """Memory does not grow by 300 scenes after the first 300: a leak of one would show."""
    def kilobytes():
        return int([line for line in open("/proc/self/status") if line.startswith("VmRSS")][0].split()[1])

    def use():
        for _ in range(300):
            scene = trivet.Scene()
            cube = scene.add("a", box())
            cube.put([0, 0, 1])
            scene.add("b", box()).try_put([0.01, 0, 1])
            scene.contacts(), scene.check(), scene.snapshot(), cube.try_put([0, 0, 0])

    use()
    before = kilobytes()
    use()
    assert kilobytes() - before < 4000
