#!/usr/bin/env python3
"""Writes MJCF scenes with the faults of public start states, and measures `trivet check` on them.

    perf/foreign_scenes.py FOLDER [--count 10]                    that many of every kind, for scenes_at_rest.py
    perf/foreign_scenes.py FOLDER --check TRIVET [--count 112]    and the rate and memory of one check of all

The kinds are self-made after what benchmarks ship: things 6 to 16 cm above their table, things up to 38 mm inside the floor, dominoes a
micrometre deep, a keyframe that lets a cube fall, geoms with a margin 10 mm up and in contact, curved shapes in the air, an open drawer
with things over it, and a true scene."""
import argparse
import os
import random
import subprocess
import time
from pathlib import Path

FLOOR = '<geom type="plane" size="3 3 .1"/>\n'
TABLE = FLOOR + '<body name="table" pos="0 0 .4"><geom type="box" size=".5 .4 .4"/></body>\n'
TOP = 0.8


def body(name, x, y, z, geom, turn=0.0):
    return '<body name="%s" pos="%.5f %.5f %.7f" euler="0 0 %.3f"><freejoint/><geom %s/></body>\n' % (name, x, y, z, turn, geom)


def things(generator, count, sizes=(0.02, 0.05)):
    """Boxes that do not meet each other: (x, y, half size, geom)."""
    for i in range(count):
        size = round(generator.uniform(*sizes), 4)  # as it is written
        yield -0.32 + 0.16 * (i % 5), -0.2 + 0.2 * (i // 5), size, 'type="box" size="%.4f %.4f %.4f"' % (size, size, size)


def above(generator):
    return TABLE + "".join(body("thing %d" % i, x, y, TOP + size + generator.uniform(0.06, 0.16), geom, generator.uniform(0, 90))
                           for i, (x, y, size, geom) in enumerate(things(generator, 8)))


def in_floor(generator):
    return FLOOR + "".join(body("thing %d" % i, x, y, size - generator.uniform(0.0004, 0.0377), geom)
                           for i, (x, y, size, geom) in enumerate(things(generator, 8, (0.03, 0.05))))


def dominoes(generator):
    way = generator.uniform(0.03, 0.04)
    return FLOOR + "".join(body("domino %d" % i, way * i - 0.4, 0, 0.05 - 1e-6, 'type="box" size=".006 .025 .05"') for i in range(20))


def keyframe(generator):
    x, y = generator.uniform(-0.3, 0.3), generator.uniform(-0.3, 0.3)
    return TABLE + body("cube", 0, 0, 2, 'type="box" size=".02 .02 .02"'), \
        '<keyframe><key name="home" qpos="%.5f %.5f .86 1 0 0 0"/></keyframe>' % (x, y)


def margins(generator, gap=0.01, margin=0.0005):
    scene = TABLE + "".join(body("thing %d" % i, x, y, TOP + size + gap, geom) for i, (x, y, size, geom) in enumerate(things(generator, 4)))
    return scene.replace("<geom ", '<geom margin="%g" ' % margin)


def curved(generator):
    kinds = ('type="sphere" size="%.3f"', 'type="cylinder" size="%.3f .05"', 'type="capsule" size="%.3f .06"',
             'type="ellipsoid" size="%.3f .03 .05"')
    rim = "".join('<geom type="box" pos="%g %g .42" size="%g %g .02"/>' % one for one in
                  ((0.5, 0, 0.01, 0.4), (-0.5, 0, 0.01, 0.4), (0, 0.4, 0.5, 0.01), (0, -0.4, 0.5, 0.01)))
    scene = TABLE.replace("</body>", rim + "</body>")
    return scene + "".join(body("thing %d" % i, -0.25 + 0.17 * i, 0, TOP + generator.uniform(0.08, 0.12),
                                kinds[i] % generator.uniform(0.03, 0.04)) for i in (1, 3))


def drawer(generator):
    unit = ('<body name="unit" pos="0 0 .3"><geom type="box" pos="0 0 .29" size=".2 .2 .01"/>'
            '<geom type="box" pos=".21 0 0" size=".01 .2 .3"/><geom type="box" pos="-.21 0 0" size=".01 .2 .3"/>'
            '<body name="drawer"><joint name="drawer" type="slide" axis="0 -1 0" range="0 .3"/>'
            '<geom type="box" size=".19 .19 .005"/><geom type="box" pos="0 -.19 .04" size=".19 .005 .04"/></body></body>\n')
    cube = 'type="box" size=".02 .02 .02"'
    things_in = "".join(body("thing %d" % i, -0.1 + 0.1 * i, -0.35, 0.325, cube) for i in range(3))
    pose = "".join(" %.5f -.35 %.5f 1 0 0 0" % (-0.1 + 0.1 * i, 0.335) for i in range(3))
    return FLOOR + unit + things_in, '<keyframe><key name="open" qpos=".25%s"/></keyframe>' % pose


def true(generator):
    return TABLE + "".join(body("thing %d" % i, x, y, TOP + size + 2e-7, geom) for i, (x, y, size, geom) in enumerate(things(generator, 8)))


KINDS = {"above": above, "in-floor": in_floor, "dominoes": dominoes, "keyframe": keyframe, "margin": margins,
         "margin-touching": lambda generator: margins(generator, 0, 0.001), "curved": curved, "drawer": drawer, "true": true}


def write(folder, count):
    for kind, make in KINDS.items():
        for seed in range(count):
            made = make(random.Random(seed))
            world, rest = made if isinstance(made, tuple) else (made, "")
            (folder / ("%s %03d.xml" % (kind, seed))).write_text(
                '<mujoco><compiler autolimits="true"/><worldbody>\n%s</worldbody>%s</mujoco>\n' % (world, rest))


def check(program, folder):
    """One process that checks all; its processor time and largest memory."""
    begin = time.monotonic()
    process = subprocess.Popen([program, "check", str(folder), "--report", str(folder / "verdicts.jsonl")],
                               stdout=subprocess.PIPE, text=True)
    last = process.stdout.read().splitlines()[-1]
    _, _, used = os.wait4(process.pid, 0)
    scenes = len(list(folder.glob("*.xml")))
    seconds = used.ru_utime + used.ru_stime
    print(last)
    print("%d scenes: %.1f s of processor time, %.1f ms a scene, %.0f a second; %.1f s elapsed; %d MB at most" % (
        scenes, seconds, 1000 * seconds / scenes, scenes / seconds, time.monotonic() - begin, used.ru_maxrss / 1024))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--count", type=int)
    parser.add_argument("--check", metavar="TRIVET")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    write(arguments.folder, arguments.count or (112 if arguments.check else 10))
    if arguments.check:
        check(arguments.check, arguments.folder)


if __name__ == "__main__":
    main()
