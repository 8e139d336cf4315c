"""Layouts by the program `trivet session`, a process of its own, over a pipe. Without bpy.

Meshes go by files, in float32. The program lets nothing stand that interpenetrates: obstacles that do are given to it as
one mesh, and reasons then name that.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import tempfile
import threading
from dataclasses import replace
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from .bodies import Body
from .layouts import UNITED, LayoutError, Outcome, Settings, Status, Verdict, near


class ProgramError(LayoutError):
    """The program ended, or answers what it should not."""


def write_ply(path: str, vertices: np.ndarray, faces: np.ndarray) -> None:
    """Binary PLY, float32."""
    rows = np.empty(len(faces), np.dtype([("n", "u1"), ("v", "<i4", 3)]))
    rows["n"], rows["v"] = 3, faces
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\n"
              f"property float z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(np.ascontiguousarray(vertices, dtype="<f4").tobytes())
        file.write(rows.tobytes())


def write_layout(folder: str, bodies: Sequence[Body], out: Sequence[str], floor: bool, operations: Sequence = ()) -> str:
    """A layout of these with its models; those of `out` have no position. operations : done as it is opened."""
    objects = []
    for body in bodies:
        vertices, faces = body.arrays()
        digest = hashlib.blake2b(np.ascontiguousarray(vertices), digest_size=12)
        digest.update(np.ascontiguousarray(faces))
        model = f"{digest.hexdigest()}.ply"
        if not os.path.exists(os.path.join(folder, model)):
            write_ply(os.path.join(folder, model), vertices, faces)
        entry = {"name": body.name, "model": model, "up": "z", "fixed": body.fixed,
                 "material": {"friction": body.friction, "density": body.density}}
        if body.name not in out:
            entry["position"] = body.origin.tolist()
        objects.append(entry)
    path = os.path.join(folder, "layout.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"trivet": 1, "floor": floor, "objects": objects, "operations": list(operations)}, file)
    return path


def matrix_of(position: Sequence[float], wxyz: Sequence[float]) -> np.ndarray:
    """(4, 4) of a position and a unit quaternion."""
    w, x, y, z = wxyz
    out = np.eye(4)
    out[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                   [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                   [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    out[:3, 3] = position
    return out


def outcome_of(answer: Mapping[str, Any]) -> Outcome:
    ok = answer.get("status") == "ok"
    return Outcome(ok, "" if ok else answer.get("cause", answer.get("status", "error")), answer.get("reason", ""),
                   tuple(answer.get("objects", ())), answer.get("ended", ""), answer.get("blocked_by") or "",
                   tuple(one["name"] for one in answer.get("gave_way", ())), tuple(answer.get("carried", ())))


def verdict_of(report: Mapping[str, Any]) -> Verdict:
    pairs = report["check"]["pairs"]
    whole = report["stability"]
    margin = whole.get("margin")
    return Verdict(tuple((p["a"], p["b"]) for p in pairs if p["kind"] == "crossing"),
                   tuple((p["a"], p["b"]) for p in pairs if p["kind"] == "contained"),
                   tuple(report["check"]["not_at_rest"]), tuple(whole["topples"]), whole["status"],
                   float("inf") if margin is None else margin)


def _detection(settings: Settings) -> list:
    return ["--detector", settings.detector, "--device", settings.device_name]


class _Session:
    """The process and its lines."""

    def __init__(self, program: str, layout: str, settings: Settings) -> None:
        self._process = subprocess.Popen(
            [program, "session", layout, "--quiet", "--clearance", repr(settings.clearance), "--operation-seconds",
             repr(settings.seconds), *_detection(settings)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self._write_lock, self._number = threading.Lock(), 0
        self._errors = b""
        self._reader = threading.Thread(target=self._read_errors, daemon=True)
        self._reader.start()
        try:
            self._line()  # greets
        except ProgramError:
            self.close()
            raise

    def _read_errors(self) -> None:
        for line in self._process.stderr:
            self._errors = (self._errors + line)[-4000:]

    def _line(self) -> Mapping[str, Any]:
        line = self._process.stdout.readline()
        if not line:
            self._reader.join(2.0)
            raise ProgramError("trivet session ended: " + self._errors.decode(errors="replace").strip())
        return json.loads(line)

    def send(self, request: Mapping[str, Any]) -> None:
        with self._write_lock:
            try:
                self._process.stdin.write(json.dumps(request).encode() + b"\n")
                self._process.stdin.flush()
            except (BrokenPipeError, ValueError):
                pass  # the missing answer tells

    def ask(self, request: Mapping[str, Any]) -> Mapping[str, Any]:
        self._number += 1
        self.send({**request, "id": self._number})
        while True:
            answer = self._line()
            if answer.get("id") == self._number:
                return answer

    def close(self) -> None:
        self._process.stdin.close()
        try:
            self._process.wait(5.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join()
        self._process.stdout.close()
        self._process.stderr.close()


class ProgramLayout:
    """See `layouts.Layout`."""

    def __init__(self, program: str, bodies: Sequence[Body], out: Sequence[str], settings: Settings) -> None:
        self._program, self._settings = program, settings
        self._folder = tempfile.TemporaryDirectory(prefix="trivet-")
        self._session: Optional[_Session] = None
        self._poses: dict = {}
        try:
            self._start(bodies, out)
        except BaseException:
            self.close()
            raise

    def _start(self, bodies: Sequence[Body], out: Sequence[str]) -> None:
        self._given = bodies, out
        if not bodies:
            return
        self._open(bodies, out)
        refused = [body for body in bodies if body.name not in out and self._poses.get(body.name) is None]
        if refused:
            self._open(_united(bodies, out, {body.name for body in refused}), out)
            for body in bodies:
                self._poses.setdefault(body.name, matrix_of(body.origin, (1, 0, 0, 0)))

    @staticmethod
    def version(program: str) -> str:
        """Raises ProgramError for what is not the program `trivet`."""
        try:
            told = subprocess.run([program, "--version"], capture_output=True, text=True, timeout=30, check=False)
        except (OSError, ValueError, subprocess.TimeoutExpired) as error:  # text that is none is a ValueError
            raise ProgramError(f"{program} does not run: {error}") from error
        words = told.stdout.split()
        if told.returncode != 0 or len(words) != 2 or words[0] != "trivet":
            raise ProgramError(f"{program} is not the program trivet")
        return words[1]

    def _open(self, bodies: Sequence[Body], out: Sequence[str], operations: Sequence = ()) -> Sequence[Mapping[str, Any]]:
        self.close_session()
        layout = write_layout(self._folder.name, bodies, out, self._settings.floor, operations)
        self._session = _Session(self._program, layout, self._settings)
        self._poses = {}
        entries = self._session.ask({"query": "objects"})["objects"]
        self._note_poses(entries)
        return entries

    def _note_poses(self, entries: Sequence[Mapping[str, Any]]) -> None:
        for entry in entries:
            there = entry["position"] is not None
            self._poses[entry["object"]] = matrix_of(entry["position"], entry["rotation"]) if there else None

    def _ask(self, request: Mapping[str, Any]) -> Mapping[str, Any]:
        if self._session is None:
            raise ProgramError("the layout is empty")
        answer = self._session.ask(request)
        self._note_poses(answer.get("poses", ()))
        return answer

    def perform(self, operation: Mapping[str, Any]) -> Outcome:
        return outcome_of(self._ask(operation))

    def mend(self) -> Mapping[str, str]:
        """A layout that begins with it stands as it is given, so all begins again. Once more names what has no place."""
        if not self._given[0]:
            return {}
        self._open(*self._given, [{"op": "mend"}])
        return {one["object"]: one["why"] for one in self._ask({"mend": True}).get("unable", ())}

    def undo(self) -> None:
        self._ask({"undo": True})

    def pose(self, name: str) -> Optional[np.ndarray]:
        return self._poses.get(name)

    def status(self, name: str) -> Status:
        answer = self._ask({"query": {"object": name}})
        if answer["status"] != "ok":
            return Status("fixed")
        margin, friction = answer.get("stability_margin"), answer.get("least_friction")
        return Status(answer["state"], _names(answer["held_by"]), _names(answer["lying_on"]),
                      float("nan") if margin is None else margin, float("nan") if friction is None else friction)

    def verdict(self) -> Verdict:
        return verdict_of(_report(self._program, self._saved(), self._settings))

    def export(self, path: str, collision: str) -> list:
        done = _run(self._program, "export", self._saved(), "-o", path, "--collision", collision)
        if done.returncode != 0:
            raise ProgramError(done.stderr.strip())
        return [path, *done.stderr.splitlines()]

    def cancel(self) -> None:
        if self._session is not None:
            self._session.send({"cancel": True, "id": "cancel"})

    def close_session(self) -> None:
        if self._session is not None:
            self._session.close()
            self._session = None

    def close(self) -> None:
        self.close_session()
        self._folder.cleanup()

    def _saved(self) -> str:
        path = os.path.join(self._folder.name, "scene.glb")
        self._ask({"save": path})
        return path


def judge(program: str, bodies: Sequence[Body], settings: Settings):
    """See `backends.Backend.judge`; meshes to float32."""
    if not bodies:
        return Verdict(), {}
    with tempfile.TemporaryDirectory(prefix="trivet-") as folder:
        report = _report(program, write_layout(folder, bodies, [], settings.floor), settings)
    return verdict_of(report), {one["name"]: _status(one, report["objects"]) for one in report["objects"]}


def crossings(program: str, bodies: Sequence[Body], about: Sequence[str]) -> list:
    """See `backends.Backend.crossings`; meshes to float32."""
    verdict, _ = judge(program, near(bodies, set(about)), Settings(floor=False))
    return [pair for pair in (*verdict.crossings, *verdict.contained) if set(pair) & set(about)]


def _names(contacts: Sequence[Mapping[str, Any]]) -> tuple:
    return tuple(dict.fromkeys(one["name"] for one in contacts))


def _status(one: Mapping[str, Any], entries: Sequence[Mapping[str, Any]]) -> Status:
    loads = tuple(other["name"] for other in entries if one["name"] in other["supported_by"])
    margin, friction = one.get("stability_margin"), one.get("least_friction")
    return Status(one["state"], tuple(one["supported_by"]), loads, float("nan") if margin is None else margin,
                  float("nan") if friction is None else friction)


def _run(program: str, *arguments: str) -> Any:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def _report(program: str, scene: str, settings: Settings) -> Mapping[str, Any]:
    done = _run(program, "check", scene, "--json", "--clearance", repr(settings.clearance), *_detection(settings))
    if done.returncode not in (0, 1):
        raise ProgramError(done.stderr.strip() or done.stdout.strip())
    return json.loads(done.stdout)


def _united(bodies: Sequence[Body], out: Sequence[str], refused: set) -> list:
    """All that does not move as one body, with what cannot stand where it is."""
    still = [body for body in bodies if body.name not in out and (body.fixed or body.name in refused)]
    one = replace(still[0], name=UNITED, fixed=True, parts=[part for body in still for part in body.parts])
    names = {body.name for body in still}
    return [one, *(body for body in bodies if body.name not in names)]
