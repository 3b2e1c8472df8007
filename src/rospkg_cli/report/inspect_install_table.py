"""The install table and the launch files of packages, for people and for programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import PurePosixPath
from typing import IO, Any

from .. import __version__
from ..checks.read_sentences import why_unknown
from ..control_characters import visible, without_workflow_commands
from ..package.inspection import Inspection
from ..package.install_table import PYTHON, InstalledFile, InstallKind
from .color import paint
from .dump import dump
from .inspect_launch import launch_document, launch_lines

SCHEMA = 1
SITE_PACKAGES = "lib/python3.*/site-packages"
"""How the folder of Python packages is shown: its name depends on the Python that builds."""

TITLES: dict[InstallKind, str] = {
    "executable": "executables",
    "share": "share files",
    "module": "Python modules",
    "library": "libraries",
    "header": "headers",
    "other": "other files",
}
MAX_WIDTH = 72


def destination(row: InstalledFile) -> str:
    """Return where a row is installed, relative to the prefix."""
    inside = row.destination.removeprefix(PYTHON + "/")
    return row.destination if inside == row.destination else f"{SITE_PACKAGES}/{inside}"


def render_text(inspections: Sequence[Inspection], root: str, stream: IO[str], color: bool) -> None:
    """Write a list for each package; `root` is the way from the working directory to the root of the run."""
    for number, inspection in enumerate(inspections):
        where = visible(str(PurePosixPath(root, inspection.folder)))
        kind = f"{visible(inspection.build_type)}, {where}" if inspection.build_type else where
        title = f"{paint(visible(inspection.name), 'bold', color)} ({kind})"
        stream.write("\n" * bool(number))
        for line in (title, *lines(inspection, color)):
            stream.write(without_workflow_commands(line.rstrip()) + "\n")


def lines(inspection: Inspection, color: bool) -> Iterator[str]:
    for what, title in TITLES.items():
        rows = sorted(inspection.table.of(what), key=destination)
        made = [(destination(row), (row.entry or row.source or "made by the build") + under(row)) for row in rows]
        yield from table(title, made, color)
    parts = [(e.name, e.target + (f", run by {e.executable}" if e.executable else "")) for e in inspection.components]
    yield from table("components", parts, color)
    if inspection.interfaces:
        yield f"  {paint('interfaces', 'cyan', color)}"
        yield from (f"    {visible(name)}" for name in inspection.interfaces)
    if inspection.launch:
        yield f"  {paint('launch files', 'cyan', color)}"
        for file in inspection.launch:
            yield from launch_lines(file, color)
    if inspection.table.unknown:
        yield f"  {paint('not known', 'yellow', color)}"
        yield from (f"    {visible(text)}" for text in dict.fromkeys(not_known(inspection)))


def table(title: str, rows: Sequence[tuple[str, str]], color: bool) -> Iterator[str]:
    """Yield a title, and a line for each thing with what it is made of; nothing where there is none."""
    shown = [(visible(name), visible(made)) for name, made in rows]
    if shown:
        yield f"  {paint(title, 'cyan', color)}"
    width = min(max((len(name) for name, _ in shown), default=0), MAX_WIDTH)
    yield from (f"    {name:<{width}}  {paint('<- ' + made, 'dim', color)}" for name, made in shown)


def under(row: InstalledFile) -> str:
    """Return the condition that a row is there under."""
    return " (perhaps)" if row.maybe else " (with tests)" if row.testing else ""


def not_known(inspection: Inspection) -> Iterator[str]:
    reasons: dict[str, list[str]] = {}
    for each in inspection.table.unknown:
        line, _ = inspection.position(each.path, each.span.start)
        reasons.setdefault(f"{why_unknown(each)} ({each.path}:{line})", []).append(TITLES[each.what])
    return (f"{', '.join(dict.fromkeys(titles))}: {reason}" for reason, titles in reasons.items())


def render_json(inspections: Sequence[Inspection], root: str, stream: IO[str]) -> None:
    """Write one document; paths are relative to the working directory, lines and columns count from 1."""
    packages = [document(inspection, root) for inspection in inspections]
    tool = {"name": "rospkg", "version": __version__}
    dump({"schema": SCHEMA, "tool": tool, "packages": packages}, stream)


def document(inspection: Inspection, root: str) -> dict[str, Any]:
    launched = {file.path: file.source for file in inspection.launch}

    def at(path: str, offset: int) -> dict[str, Any]:
        source = launched.get(path)
        line, column = source.position(offset) if source else inspection.position(path, offset)
        return {"path": str(PurePosixPath(root, inspection.folder, path)), "line": line, "column": column}

    return {
        "name": inspection.name,
        "path": str(PurePosixPath(root, inspection.folder)),
        "build_type": inspection.build_type,
        "installed": [
            {
                "what": row.what,
                "destination": destination(row),
                "source": row.source,
                "entry": row.entry,
                "certain": not row.maybe,
                "testing": row.testing,
                "said": at(row.path, row.span.start) if row.path else None,
            }
            for row in sorted(inspection.table.rows, key=lambda row: (row.destination, row.source))
        ],
        "components": [
            {
                "name": part.name,
                "target": part.target,
                "executable": part.executable,
                "said": at(part.path, part.offset),
            }
            for part in inspection.components
        ],
        "interfaces": list(inspection.interfaces),
        "launch_files": [launch_document(file, at) for file in inspection.launch],
        "unknown": [
            {"what": each.what, "why": why_unknown(each), "said": at(each.path, each.span.start)}
            for each in inspection.table.unknown
        ],
    }
