"""Frictionless 2D contact: solves scenes with error bars, and judges the answers of other codes.

>>> import contact_vv
>>> run = contact_vv.solve("cylinder", element="line")
>>> print(run.numbers["second-moment-width"])
2.50061 ± 0.0038
>>> bool(contact_vv.judge("cylinder", run.s, run.p, area=run.contacts[0].area))
True

A scene, or case, is the name of one of the library, the path of a scene file, the text of one, or a dict with the same.
Files that a text or a dict names are found by absolute paths. Options are those of the program, with underscores, as
`contact-vv solve --help` and `contact-vv judge --help` tell them: `True` where they have no value, a list for several.
Lengths are in mm, forces in N, pressures in MPa, and coordinates along an arc in radians.
"""

from __future__ import annotations

import base64
import html
import importlib
import json
import math
import os
import shutil
import subprocess
import sysconfig
import tempfile
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any, ClassVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__ = version("contact-vv")

Array = NDArray[np.float64]
Scene = Union[str, "os.PathLike[str]", Mapping[str, Any]]
Option = Union[str, float, bool, None, Sequence[str]]


class Error(Exception):
    """What the program refuses, and what to do about it, in its own words."""


@dataclass(frozen=True)
class Number:
    """A number of a contact or a body, and its error bar: what it may be off; not a number where that is not known."""

    of: str
    quantity: str
    value: float
    bar: float

    def __str__(self) -> str:
        return f"{self.value:.6g} ± {self.bar:.2g}"


@dataclass(frozen=True)
class Contact:
    """The points of a contact: coordinates in `unit`, pressures, remaining gaps, and the areas they act on."""

    name: str
    unit: str
    s: Array
    p: Array
    gap: Array
    area: Array


class Solution:
    """A scene that was solved, or by its `outcome` was not.

    `numbers` has every number with its bar by name, `contacts` the points of each contact; `s`, `p` and `gap` are those
    of the first. `displacement` has a row for each of `nodes`. `document` is all that the program prints.
    """

    def __init__(self, document: dict[str, Any], nodes: Array, displacement: Array) -> None:
        self.document, self.nodes, self.displacement = document, nodes, displacement
        self.outcome: str = document["outcome"]
        self.numbers = _by_name(document.get("error_bars", []), ["of", "quantity", "value", "bar"])
        units, columns = document["units"], ["position", "pressure", "gap", "area"]
        contacts = document["contacts"]
        self.contacts = [Contact(of["name"], units[of["coordinate"]], *_columns(of, columns)) for of in contacts]
        self.s, self.p, self.gap = self.contacts[0].s, self.contacts[0].p, self.contacts[0].gap

    def __repr__(self) -> str:
        numbers = [f"{name}: {number}" for name, number in self.numbers.items()]
        return "\n".join([f"{self.document['case']}: {self.outcome}", *numbers])


class Verdicts:
    """What an answer was found to be: true where nothing that could be judged failed, and printed as a table.

    `document` is all that the program prints, by `contact-vv schema`: checks, usual mistakes, what is missing.
    """

    refused: ClassVar[Verdicts | None] = None
    """Those that were asked last, where they are not true: what a failed `assert all(…)` of a test is about."""

    def __init__(self, document: dict[str, Any]) -> None:
        self.document = document

    def __bool__(self) -> bool:
        """Whether nothing failed.

        >>> [(bool(Verdicts({"met": met})), Verdicts.refused is None) for met in (False, True)]
        [(False, False), (True, True)]
        """
        met = bool(self.document["met"])
        Verdicts.refused = None if met else self
        return met

    def __repr__(self) -> str:
        return f"{self.document['case']}: {'met' if self else 'NOT MET'}\n{self.document['table']}"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(repr(self))}</pre>"

    def plot(self, axes: Any = None) -> Any:
        """Draws the pressures on those of the reference by matplotlib, and returns the axes.

        >>> from unittest.mock import Mock
        >>> drawn = judge("bars", [0, 12, 25], [50, 50, 50]).plot(Mock()).plot.call_args_list
        >>> [round(float(call.args[1][0]), 3) for call in drawn]
        [50.0, 52.5]
        """
        axes = axes or importlib.import_module("matplotlib.pyplot").gca()
        for one in self.document["contacts"]:
            s, p, truth = _columns(one, ["position", "pressure", "reference"])
            axes.plot(s, p, ".-", label=f"{one['name']}: handed in")
            axes.plot(s, truth, "k--", label=f"{one['name']}: reference")
            axes.set(xlabel=f"contact coordinate [{one['unit']}]", ylabel="contact pressure [MPa]")
        axes.legend()
        return axes


def solve(scene: Scene, **options: Option) -> Solution:
    """Solves a scene; by default coarser meshes too, which tell the bar of every number.

    >>> run = solve("bars", element="node", no_error_bar=True)
    >>> run.outcome, run.s.shape == run.p.shape == run.gap.shape, run.nodes.shape == run.displacement.shape
    ('converged', True, True)
    >>> run.nodes.max(axis=0).tolist(), round(float(run.displacement.min()), 3)
    ([25.0, 100.1], -0.15)
    >>> run = solve("pin-rod", no_error_bar=True, max_iterations=2)
    >>> run, run.contacts[0].unit
    (pin-rod: not converged, 'rad')
    >>> solve("cilinder")
    Traceback (most recent call last):
    contact_vv.Error: solve: there is no case `cilinder`
     help: did you mean `cylinder`? choose one of ...
    >>> solve({"thickness": float("inf"), "title": None, "plane": {1}})
    Traceback (most recent call last):
    contact_vv.Error: `{1}` is no value of a scene
     help: give numbers, texts, lists and dicts
    >>> solve("bars", help=True)
    Traceback (most recent call last):
    contact_vv.Error: solve: an option makes it print `...…`, not an answer
     help: leave it out
    """
    with _folder(scene) as (folder, name):
        fields = folder / "fields.vtu"
        document = _document("solve", "--json=-", f"--vtu={fields}", *_typed(options), "--", name)
        grid = ElementTree.parse(fields).getroot()
    nodes, displacement = _plane(grid, ".//Points/DataArray"), _plane(grid, ".//*[@Name='displacement']")
    return Solution(document, nodes, displacement)


def judge(
    case: Scene,
    s: ArrayLike,
    p: ArrayLike,
    unit: str = "MPa",
    length: str = "mm",
    gap: ArrayLike | None = None,
    area: ArrayLike | None = None,
    **options: Option,
) -> Verdicts:
    """Judges pressures `p` in `unit` at contact coordinates `s` in `length`, which is deg or rad along an arc.

    Remaining gaps in mm and the areas in mm² that pressures act on may be given too; without areas, pressures are linear
    between the points. What is masked is not a number, and refused.

    >>> s = np.linspace(0, 4, 81)
    >>> p = 5769.23 * np.sqrt(np.maximum(1 - (s / 2.5) ** 2, 0))
    >>> bool(judge("truncated-hertz", s, p)), bool(judge("truncated-hertz", s, 1.03 * p))
    (True, False)
    >>> bool(judge("truncated-hertz", s / 1e3, p * 1e6, unit="Pa", length="m", tolerance="0.5 %"))
    True
    >>> run = solve("bars", element="line", no_error_bar=True)
    >>> bool(judge("bars", run.s, run.p, gap=run.gap, area=run.contacts[0].area))
    True
    >>> run = solve("truncated-hertz", no_error_bar=True)
    >>> bool(judge("truncated-hertz", run.s, run.p, gap=run.gap))
    True
    >>> judge("bars", [0, 12, 25], [52.5 + 1e-9] * 3).document["checks"][1]["value"]
    52.500000001
    >>> judge("bars", np.ma.masked_greater([0, 12, 25], 20), [52.5, 52.5, 52.5])
    Traceback (most recent call last):
    contact_vv.Error: ...`nan`, which is no number...
    >>> judge("bars", [0, 12, 25], [52.5])
    Traceback (most recent call last):
    contact_vv.Error: the arrays have different shapes: position [mm] (3,), pressure [MPa] (1,)...
    """
    with tempfile.TemporaryDirectory(prefix="contact-vv-") as folder:
        given = {f"position [{length}]": s, f"pressure [{unit}]": p, "gap [mm]": gap, "area [mm2]": area}
        there = {name: np.ma.asarray(of, dtype=float) for name, of in given.items() if of is not None}
        columns = {name: np.ma.filled(of, np.nan) for name, of in there.items()}
        if len({column.shape for column in columns.values()}) > 1:
            shapes = ", ".join(f"{name} {column.shape}" for name, column in columns.items())
            raise Error(f"the arrays have different shapes: {shapes}\n help: give a number for every point")
        answer, table = Path(folder, "answer.csv"), np.column_stack(list(columns.values()))
        np.savetxt(answer, table, fmt="%.17g", delimiter=",", header=",".join(columns), comments="", encoding="utf-8")
        return judge_file(case, answer, **options)


def judge_file(case: Scene, answer: str | os.PathLike[str], **options: Option) -> Verdicts:
    """Judges a file that the program reads: a table, a VTK grid, of CalculiX, or JSON by `contact-vv schema answer`."""
    with _folder(case) as (_, name):
        return Verdicts(_document("judge", "--json", *_typed(options), "--", name, os.fspath(answer)))


def reference(case: Scene) -> dict[str, Number]:
    """What answers are held against, by the names of `judge`: numbers of the closed form, or of our own fine answer.

    >>> print(reference("cylinder")["second-moment width [mm]"])
    2.5 ± 0.0063
    >>> list(reference("bars"))
    ['second-moment width [mm]', 'peak pressure [MPa]', 'contact resultant [N]']
    """
    with _folder(case) as (folder, name):
        own = folder / "own.csv"
        _output("solve", "--no-error-bar", f"--csv={own}", "--", name)
        checks = judge_file(name, own).document["checks"]
    values = [check for check in checks if check["unit"] is not None]
    return _by_name(values, ["contact", "quantity", "reference", "reference_bar"])


def cases() -> dict[str, str]:
    """The cases of the library by name, and what each is.

    >>> cases()["bars"]
    'two bars in line closing a gap'
    """
    return {case["name"]: case["title"] for case in _document("list", "--json")}


def program() -> str:
    """The path of the program, wherever pip has laid it; else of one in PATH."""
    beside = str(Path(__file__).resolve().parents[1] / "bin")
    folders = [sysconfig.get_path("scripts"), sysconfig.get_path("scripts", f"{os.name}_user"), beside]
    found = shutil.which("contact-vv", path=os.pathsep.join(folders)) or shutil.which("contact-vv")
    if found is None:
        remedy = "`pip install --force-reinstall contact-vv`, or `cargo install --path .` in a checkout"
        raise Error(f"the program `contact-vv` is neither where pip lays programs nor in PATH\n help: {remedy}")
    return found


def _output(*arguments: str) -> str:
    """What the program prints, also where a check fails (1) or a run does not converge (3); else it refuses."""
    command = [program(), *arguments]
    try:
        ended = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8")
    except (OSError, ValueError) as refused:
        raise Error(f"{command[0]} cannot be started with {arguments}: {refused}") from None
    if ended.returncode not in (0, 1, 3):
        told = ended.stderr.strip() or f"the program ended with {ended.returncode}"
        raise Error(told[len("error: ") :] if told.startswith("error: ") else told)
    return ended.stdout


def _document(*arguments: str) -> Any:
    """What the program prints as JSON; refused where an option makes it print something else, as `help=True` does."""
    printed = _output(*arguments)
    try:
        return json.loads(printed)
    except ValueError:
        told = printed.strip().partition("\n")[0]
        raise Error(f"{arguments[0]}: an option makes it print `{told}…`, not an answer\n help: leave it out") from None


@contextmanager
def _folder(scene: Scene) -> Iterator[tuple[Path, str]]:
    """A folder that is removed again, and the scene as the program takes it; a text is written to a file there."""
    with tempfile.TemporaryDirectory(prefix="contact-vv-") as folder:
        name = "\n".join(_pairs(scene)) + "\n" if isinstance(scene, Mapping) else os.fspath(scene)
        if "\n" in name:
            file = Path(folder, "scene.toml")
            file.write_text(name, encoding="utf-8")
            name = str(file)
        yield Path(folder), name


def _pairs(table: Mapping[str, Any]) -> list[str]:
    return [f"{json.dumps(key)} = {_toml(value)}" for key, value in table.items() if value is not None]


def _toml(value: Any) -> str:
    """A value as TOML in one line, which has strings, numbers and booleans as JSON has them.

    >>> print(_toml({"a.b": np.int64(2), "c": float("inf"), "d": [True, "µ"], "e": None}))
    {"a.b" = 2, "c" = inf, "d" = [true, "µ"]}
    """
    if isinstance(value, Mapping):
        return "{" + ", ".join(_pairs(value)) + "}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    value = value.item() if isinstance(value, np.generic) else value
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    try:
        return json.dumps(os.fspath(value) if isinstance(value, os.PathLike) else value, ensure_ascii=False)
    except TypeError:
        raise Error(f"`{value!r}` is no value of a scene\n help: give numbers, texts, lists and dicts") from None


def _typed(options: Mapping[str, Option]) -> list[str]:
    """Options as one types them.

    >>> _typed({"no_error_bar": True, "all": False, "csv": None, "unit": ["position=m", "gap=um"]})
    ['--no-error-bar', '--unit=position=m', '--unit=gap=um']
    """
    lists = {name: value if isinstance(value, (list, tuple)) else [value] for name, value in options.items()}
    given = [("--" + name.replace("_", "-"), one) for name, value in lists.items() for one in value]
    return [name if one is True else f"{name}={one}" for name, one in given if one is not None and one is not False]


def _plane(grid: ElementTree.Element, path: str) -> Array:
    """The components in the plane of vectors in a VTK grid: base64 of 8 bytes with their size, and of the numbers."""
    numbers = np.frombuffer(base64.b64decode(grid.findtext(path, "")), "<f8", offset=8)
    return numbers.reshape(-1, 3)[:, :2].astype(float)


def _columns(contact: Mapping[str, Any], names: Sequence[str]) -> list[Array]:
    """Columns of the points of a contact by name; null is not a number."""
    return [np.array([point[name] for point in contact["profile"]], dtype=float) for name in names]


def _by_name(rows: Sequence[Mapping[str, Any]], keys: Sequence[str]) -> dict[str, Number]:
    """Numbers by their quantity, and by what they are of where several have one; of one that stands twice the first.

    >>> rows = [("left", "end", 1, 0.1), ("left", "end", 2, 0.1), ("right", "end", 3, None), ("left", "peak", 4, 0)]
    >>> {name: one.value for name, one in _by_name([dict(zip("abcd", row)) for row in rows], "abcd").items()}
    {'end of left': 1.0, 'end of right': 3.0, 'peak': 4.0}
    """
    found: dict[tuple[str, str], Number] = {}
    for of, quantity, *numbers in ([row[key] for key in keys] for row in rows):
        value, bar = np.array(numbers, dtype=float).tolist()
        found.setdefault((quantity, of), Number(of, quantity, value, bar))
    count = Counter(quantity for quantity, _ in found)
    return {name if count[name] == 1 else f"{name} of {of}": one for (name, of), one in found.items()}
