"""Engines of the field: each takes a case's start and gives poses, {name: {position, rotation}}, and the CPU seconds it took.

An engine that is a program is called as PROGRAM SECONDS SCENE.xml, a scene in MuJoCo's format whose meshes are cut into
convex parts; start.json beside it names the models themselves. It simulates so many seconds and prints a line of JSON:
{"objects": [{"name": NAME, "position": [x, y, z], "rotation": [w, x, y, z]}, ...]}.
"""
import json
import os
import resource
import shlex
import shutil
import subprocess
import xml.etree.ElementTree

import cases

HERE = os.path.dirname(os.path.abspath(__file__))
LOADERS = os.path.join(HERE, "..", "..", "tests", "interop", "simulators")
PACKAGES = os.path.join(HERE, "..", "..", "tests", "interop")
NODE_ENGINES = ("mujoco", "rapier", "jolt")
BUILT_ENGINES = ("bullet", "mujoco2")  # programs of this build, in the folder --programs


def children_cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def install_node_engines(folder):
    """Copies the loaders to `folder`, and installs what they import; modules are found beside scripts."""
    os.makedirs(folder, exist_ok=True)
    for source in (LOADERS, PACKAGES):
        for name in os.listdir(source):
            if name.endswith((".mjs", "package.json", "package-lock.json")):
                shutil.copy(os.path.join(source, name), folder)
    if not os.path.isdir(os.path.join(folder, "node_modules")):
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--ignore-scripts"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)


class Trivet:
    """Puts one object after another, the lowest first, from the same starts."""
    name, key = "Trivet", "trivet"

    def __init__(self, program):
        self.program = program

    def settle(self, case, folder):
        layout = case.layout()
        moving = sorted((o for o in layout["objects"] if not o.get("fixed")), key=lambda o: o["position"][2])
        layout["objects"] = [o if o.get("fixed") else {"name": o["name"], "model": o["model"]} for o in layout["objects"]]
        layout["operations"] = [{"op": "put", "object": o["name"], "position": cases.raised(o["position"], case.lift),
                                 "rotation": o["rotation"]} for o in moving]
        start, scene = os.path.join(folder, "puts.json"), os.path.join(folder, "trivet.glb")
        write_json(start, layout)
        before = children_cpu()
        cases.run(self.program, "run", start, "-o", scene, "--threads", "1")
        cpu = children_cpu() - before
        return cases.poses_of(self.program, scene), cpu


class Program:
    """Any engine, as a program."""

    def __init__(self, name, command, seconds, folder=None, scene="scene.xml"):
        self.name = self.key = name
        self.command, self.seconds, self.folder, self.scene = command, seconds, folder, scene

    def running(self, seconds):
        """The same engine, for another time."""
        return Program(self.key, self.command, seconds, self.folder, self.scene)

    def settle(self, case, folder):
        before = children_cpu()
        done = subprocess.run([*shlex.split(self.command), str(self.seconds), os.path.join(folder, self.scene)],
                              capture_output=True, text=True, cwd=self.folder)
        cpu = children_cpu() - before
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode != 0 or not lines:
            raise SystemExit(f"{self.name}: {case.name}: status {done.returncode}: {done.stderr}{done.stdout}")
        line = json.loads(lines[0])
        self.name = line.get("simulator", self.name)
        return {o["name"]: {key: o[key] for key in ("position", "rotation")} for o in line["objects"]}, cpu


def write_json(path, value):
    with open(path, "w") as file:
        json.dump(value, file, indent=1)


def write_start(trivet, case, folder):
    """start.json of a case, and its scene for the engines: scene.xml for MuJoCo 3 and others, scene2.xml for MuJoCo 2."""
    start, scene = os.path.join(folder, "start.json"), os.path.join(folder, "start.glb")
    write_json(start, case.free_layout())
    cases.run(trivet, "run", start, "-o", scene, "--allow-unstable")
    write_json(start, case.layout())
    for name, options in (("scene.xml", ()), ("scene2.xml", ("--mujoco", "2"))):
        path = os.path.join(folder, name)
        cases.run(trivet, "export", scene, "-o", path, "--collision", "decomposition", "--max-overlap", "1", *options)
        if case.free:
            move_bodies(path, case)


def move_bodies(path, case):
    """Moves bodies of a scene for MuJoCo from their free positions to those of the start."""
    tree = xml.etree.ElementTree.parse(path)
    bodies = {body.get("name"): body for body in tree.getroot().find("worldbody").findall("body")}
    for o in case.objects:
        if not o.get("fixed"):
            body = bodies[o["name"]]
            written, free = [float(v) for v in body.get("pos").split()], case.free[o["name"]]
            body.set("pos", " ".join(repr(w + now - then) for w, now, then in zip(written, o["position"], free)))
    tree.write(path)


def engines_of(arguments):
    """The engines that were asked for, in order."""
    node = os.path.join(arguments.work, "node")
    if set(arguments.engines) & set(NODE_ENGINES):
        install_node_engines(node)
    blender = f"{arguments.blender} -b --factory-startup --python-exit-code 9 -P {HERE}/blender_rest.py --"
    for name in arguments.engines:
        if name == "trivet":
            yield Trivet(arguments.trivet)
        elif name in NODE_ENGINES:
            yield Program(name, f"node rest.mjs {name}", arguments.seconds, node)
        elif name in BUILT_ENGINES:
            program = shlex.quote(os.path.join(arguments.programs, name + "_rest"))
            yield Program(name, program, arguments.seconds, scene="scene2.xml" if name == "mujoco2" else "scene.xml")
        elif name == "blender":
            yield Program(name, blender, arguments.seconds)
        elif "=" in name:
            yield Program(*name.split("=", 1), arguments.seconds)
        else:
            known = ", ".join(("trivet", *NODE_ENGINES, *BUILT_ENGINES, "blender"))
            raise SystemExit(f"--engines: there is no '{name}'; accepted: {known}, NAME=COMMAND")
