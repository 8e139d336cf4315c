"""Random scenes of recipes: one by one in this process, and batches of them by the program."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Union

from . import _arrays, _trivet
from ._errors import BadInputError, EnvironmentFailure
from ._scene import Scene
from ._shape import PathLike, find_importer

BatchProgress = Callable[[int, int], Any]
_LISTS = ("objects", "operations", "groups")
_LOOKS = (("environments",), ("room", "floor_images"), ("room", "wall_images"))
_POLL = 0.2  # seconds


@dataclass(frozen=True)
class MadeScene:
    """A random scene; true if the recipe accepts it.

    Attributes
    ----------
    k : int
        Its number.
    scene : Scene
        As it was made, accepted or not.
    ok : bool
    reason : str
        Why it is not accepted; else "".
    info : dict
        Its JSON, as batches have it: poses, masses, classes and supports of the objects, margins, refusals.
    """

    k: int
    scene: Scene
    ok: bool
    reason: str
    info: dict[str, Any]

    def __bool__(self) -> bool:
        return self.ok


class Recipe:
    """Random scenes, as ``trivet batch`` makes them: scene k has the same bits here, there and on any machine.

    Models are read once, when it is made. Any number of threads may use it.

    Parameters
    ----------
    recipe : path or dict
        A file, or what such a file holds; ``trivet schema recipe`` prints every key.
    seed : int
        Each seed gives other scenes.
    folder : path, optional
        Where relative paths of models start; nothing: that of the file, else the working folder.

    Raises
    ------
    BadInputError
        Naming the place, the value and what is accepted.
    EnvironmentFailure
        The program trivet-import is missing.

    Examples
    --------
    >>> recipe = trivet.Recipe("recipe.json", seed=7)                           # doctest: +SKIP
    >>> scenes = [made.scene for made in recipe.scenes(100) if made]            # doctest: +SKIP
    """

    __slots__ = ("_recipe", "_document", "_folder", "_seed")

    def __init__(self, recipe: Union[PathLike, Mapping[str, Any]], *, seed: int = 0, folder: Optional[PathLike] = None) -> None:
        self._seed = _arrays.whole("seed", seed, 0, 2 ** 64 - 1)
        name, base = "recipe", ""
        if isinstance(recipe, Mapping):
            text = _json_text(recipe)
        else:
            name = _arrays.path("recipe", recipe)
            base = os.path.dirname(name)
            text = _read(name)
        self._folder = os.path.abspath(base if folder is None else _arrays.path("folder", folder))
        self._recipe = _trivet.Recipe.read(text, name, self._folder, self._seed, find_importer())
        self._document: dict[str, Any] = json.loads(text)

    @property
    def seed(self) -> int:
        """The number that selects its scenes among those of others."""
        return self._seed

    def scene(self, k: int, *, seconds: float = 0.0) -> MadeScene:
        """Scene k.

        Parameters
        ----------
        k : int
            From 0.
        seconds : float
            TimeoutError is raised beyond; 0: no limit.

        Returns
        -------
        MadeScene
        """
        k = _arrays.whole("k", k, 0, 2 ** 63)
        scene, text = self._recipe.scene(k, _arrays.number("seconds", seconds, "seconds, 0 to 1e9", 0.0, 1e9))
        if scene is None:
            raise TimeoutError(f"scene {k} did not end within {seconds:g} s")
        info = json.loads(text)
        return MadeScene(k, Scene._of(scene), info["status"] == "ok", info.get("reason", ""), info)

    def scenes(self, count: Union[int, Iterable[int]], *, seconds: float = 0.0) -> Iterator[MadeScene]:
        """Scenes one after the other, made when they are asked for.

        Parameters
        ----------
        count : int or iterable of int
            So many from 0, or these.
        seconds : float
            Of each, as for `scene`.

        Returns
        -------
        iterator of MadeScene
        """
        numbers = range(_arrays.whole("count", count, 0, 2 ** 63)) if isinstance(count, int) else count
        return (self.scene(k, seconds=seconds) for k in numbers)

    def batch(self, out: PathLike, count: int, *, per_tar: int = 20, with_: Iterable[str] = (), jobs: int = 0,
              shard: Optional[str] = None, progress: Optional[BatchProgress] = None) -> dict[str, Any]:
        """Make scenes 0 to count - 1 into a folder, as ``trivet batch --out``: on all cores, and what is there stays.

        Parameters
        ----------
        out : path
            Folder of the batch.
        count : int
        per_tar : int
            Scenes of a unit: what an interruption may lose.
        with_ : of "scene", "contacts", "report"
            Stored beside poses.
        jobs : int
            Processes; 0: as many as cores.
        shard : str, optional
            ``"I/N"``: a share of the units.
        progress : callable, optional
            ``progress(done, total)``, units; what it raises stops the batch and is raised here.

        Returns
        -------
        dict
            Totals: "units", "ok", "refused", "failed", ...

        Raises
        ------
        BadInputError, EnvironmentFailure
            As the program says; another batch is in the folder; the program trivet is missing.
        """
        folder = _arrays.path("out", out)
        total = _arrays.whole("count", count, 1, 2 ** 63)
        each = _arrays.whole("per_tar", per_tar, 1, 10 ** 6)
        words = ["--count", str(total), "--seed", str(self._seed), "--out", folder, "--per-tar", str(each)]
        words += [word for kind in with_ for word in ("--with", _arrays.text("with_", kind))]
        with tempfile.TemporaryDirectory() as place:
            file = os.path.join(place, "recipe.json")
            Path(file).write_text(json.dumps(_with_whole_paths(self._document, self._folder)))
            return _run(["batch", file, *words], folder, -(-total // each), jobs, shard, progress)

    def __repr__(self) -> str:
        return f"<trivet.Recipe of {len(self._document.get('groups', []))} groups, seed {self._seed}>"


def batch_pictures(batch: PathLike, out: PathLike, *, form: str = "pictures", views: Optional[Mapping[str, Any]] = None,
                   jobs: int = 0, shard: Optional[str] = None, progress: Optional[BatchProgress] = None) -> dict[str, Any]:
    """Pictures and labels of a batch's scenes, as ``trivet batch pictures``; what is there stays.

    Parameters
    ----------
    batch, out : path
        Folder of the scenes, and of the pictures.
    form : "pictures", "bop" or "coco"
    views : dict, optional
        Cameras, images and look, as ``"views"`` of a recipe; nothing: the recipe's.
    jobs, shard, progress
        As for `Recipe.batch`.

    Returns
    -------
    dict
    """
    if form not in ("pictures", "bop", "coco"):
        raise _arrays.refuse("form", _arrays.short(form), '"pictures", "bop" or "coco"')
    folder = _arrays.path("out", out)
    words = ["batch", "pictures", _arrays.path("batch", batch), "--out" if form == "pictures" else "--" + form, folder]
    if views is None:
        return _run(words, folder, 0, jobs, shard, progress)
    with tempfile.TemporaryDirectory() as place:
        file = os.path.join(place, "views.json")
        Path(file).write_text(json.dumps({"views": _looks_with_whole_paths(dict(views), os.getcwd())}))
        return _run([*words, "--views", file], folder, 0, jobs, shard, progress)


def batch_export(batch: PathLike, out: PathLike, kinds: Iterable[str] = ("mjcf",), *, jobs: int = 0, shard: Optional[str] = None,
                 progress: Optional[BatchProgress] = None) -> dict[str, Any]:
    """Simulator files of a batch's scenes, as ``trivet batch export``; what is there stays.

    Parameters
    ----------
    batch, out : path
        Folder of the scenes, and of the files.
    kinds : of "mjcf", "urdf", "sdf", "usd", "glb"
    jobs, shard, progress
        As for `Recipe.batch`.

    Returns
    -------
    dict
    """
    folder = _arrays.path("out", out)
    names = ",".join(_arrays.text("kinds", kind) for kind in kinds)
    words = ["batch", "export", _arrays.path("batch", batch), "--out", folder, "--as", names]
    return _run(words, folder, 0, jobs, shard, progress)


def find_program() -> str:
    """The program trivet: named by TRIVET_PROGRAM, beside trivet-import, or on the path."""
    named = os.environ.get("TRIVET_PROGRAM")
    beside = Path(find_importer()).parent / "trivet"
    found = named or (str(beside) if beside.is_file() else shutil.which("trivet"))
    if not found:
        raise EnvironmentFailure("the program trivet is missing; accepted: on the path, or named in TRIVET_PROGRAM")
    return found


def _run(words: list[str], out: str, total: int, jobs: int, shard: Optional[str],
         progress: Optional[BatchProgress]) -> dict[str, Any]:
    words = [find_program(), *words, "--jobs", str(_arrays.whole("jobs", jobs, 0, 4096)), "--json", "--quiet"]
    if shard is not None:
        words += ["--shard", _arrays.text("shard", shard)]
    with tempfile.TemporaryFile() as printed, tempfile.TemporaryFile() as said:
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=printed, stderr=said)
        try:
            _watch(process, out, total, progress)
        finally:
            if process.poll() is None:
                process.terminate()
                process.wait()
        printed.seek(0), said.seek(0)
        lines, errors = printed.read().decode(), said.read().decode(errors="replace").strip()
    answer: dict[str, Any] = json.loads(lines) if lines.strip() else {}
    if answer and "error" not in answer:
        return answer
    says = answer["error"]["message"] if answer else errors or "trivet batch ended early"
    raise (BadInputError if process.returncode == 2 else EnvironmentFailure)(says)


# Tells `progress` of the units that are there, until the process ends.
def _watch(process: subprocess.Popen[bytes], out: str, total: int, progress: Optional[BatchProgress]) -> None:
    told = -1
    while True:
        ended = process.poll() is not None
        there = len(_units(out)) if progress else 0
        if progress and there != told:
            told = there
            progress(there, max(total, there))
        if ended:
            return
        time.sleep(_POLL)


def _units(out: str) -> list[Path]:
    return [path for path in Path(out).glob("[0-9]*/scenes-[0-9]*") if ".tmp" not in path.name]


def _json_text(recipe: Mapping[str, Any]) -> str:
    try:
        return json.dumps(recipe, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise _arrays.refuse("recipe", _arrays.short(recipe), f"what JSON has: {error}") from error


def _read(name: str) -> str:
    try:
        return Path(name).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise BadInputError(f"{name}: cannot be read: {error}") from error


def _with_whole_paths(document: Mapping[str, Any], folder: str) -> dict[str, Any]:
    out: dict[str, Any] = json.loads(json.dumps(document))
    entries = [entry for name in _LISTS for entry in out.get(name, [])]
    entries += [entry for group in out.get("groups", []) for entry in group.get("models", [])]
    for entry in entries:
        for key in ("model", "collision"):
            if isinstance(entry.get(key), str):
                entry[key] = os.path.join(folder, entry[key])
    if "views" in out:
        out["views"] = _looks_with_whole_paths(out["views"], folder)
    return out


def _looks_with_whole_paths(views: dict[str, Any], folder: str) -> dict[str, Any]:
    out: dict[str, Any] = json.loads(json.dumps(views))
    for way in _LOOKS:
        place: Any = out.get("look", {})
        for key in way[:-1]:
            place = place.get(key, {})
        if way[-1] in place:
            place[way[-1]] = [os.path.join(folder, name) for name in place[way[-1]]]
    return out
