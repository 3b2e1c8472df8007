"""A template: which files it writes, under which names, on which conditions."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from ..light_dataclasses import dataclass
from ..resources import resources
from .node_kinds import offered_kinds

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


WORKSPACE = "workspace"
"""The template that writes no package."""

ALL = "all"
"""The word for all kinds of nodes that can be written in the languages of a template."""

HEAD = {
    **dict.fromkeys(("title", "build-type", "description"), str),
    **dict.fromkeys(("kinds", "languages", "commands", "files"), list),
    **dict.fromkeys(("starts", "interfaces", "plugins"), bool),
}
"""What template.toml may hold at its top."""

ROW = {**dict.fromkeys(("source", "path", "about", "each", "when"), str), "brackets": bool}
"""What it may say of a file."""

WORDS = {str: "a string", list: "a list of strings", bool: "true or false"}


@dataclass(frozen=True)
class TemplateFile:
    """One file of a template, or one for each item of a list."""

    source: str
    """Below `files/`, or `_shared/…`, with `{{ }}`; on disk it ends in `.j2`."""
    path: str
    """Where it is written, with `{{ }}`."""
    about: str
    """What the file is for, in a few words, with `{{ }}`; "" where its name says it."""
    each: str = ""
    """The answer that holds the items; an item goes by the name in the singular (`nodes`: `node`)."""
    when: str = ""
    """An expression; the file is written where it holds."""
    brackets: bool = False
    """Whether the source has `[[ ]]` and `[% %]`, because `{{ }}` means something else in its language."""


@dataclass(frozen=True)
class Template:
    name: str
    title: str
    build_type: str
    description: str
    """Of a package whose user gave none, with `{{ }}`."""
    kinds: tuple[str, ...]
    """The kinds of nodes that it can write, first the one that is written where none is named."""
    languages: tuple[str, ...]
    """The languages of the nodes, first the one of a node that names none."""
    starts: bool
    """Whether it starts what other packages have."""
    interfaces: bool
    """Whether it generates messages, services and actions."""
    plugins: bool
    """Whether it has plugins for other programs."""
    files: tuple[TemplateFile, ...]
    commands: tuple[str, ...]
    """What to type next, from the root of the workspace, with `{{ }}`."""
    folder: Path
    """Where its template.toml is."""

    @property
    def launches(self) -> bool:
        """Whether it has launch files in the format that is asked for."""
        return any("launch.{{ launch }}" in file.path for file in self.files)

    @property
    def generates(self) -> bool:
        """Whether it has definitions that the code for parameters is generated from."""
        return any("{{ node.definitions }}" in file.path for file in self.files)

    @property
    def folders(self) -> tuple[Path, ...]:
        """The folders that sources and includes are looked for in."""
        return (self.folder / "files", resources("templates"))


def template_names() -> tuple[str, ...]:
    """Return the names of all templates of packages."""
    return tuple(sorted({path.parent.name for path in resources("templates").glob("*/template.toml")} - {WORKSPACE}))


def load_template(name: str) -> Template:
    """Read one of our templates."""
    return read_template(resources("templates") / name)


def check_types(data: Any, wanted: Mapping[str, type]) -> None:
    """Raise TypeError for a value of another type than is wanted; lists are of texts, but for that of the files."""
    if not isinstance(data, dict):
        raise TypeError("`files` must be tables: [[files]]")
    for key, value in data.items():
        kind = wanted.get(key, object)
        texts = value if kind is list and key != "files" and isinstance(value, list) else ()
        if not isinstance(value, kind) or not all(isinstance(text, str) for text in texts):
            raise TypeError(f"`{key}` must be {WORDS[kind]}")


def read_template(folder: Path) -> Template:
    """Read a template; raises OSError, and ValueError, KeyError or TypeError where its template.toml is wrong."""
    data = tomllib.loads((folder / "template.toml").read_text("utf-8"))
    if data.get("kinds") == ALL:
        data["kinds"] = list(offered_kinds(data.get("languages", ())))
    check_types(data, HEAD)
    for row in data.get("files", ()):
        check_types(row, ROW)
    return Template(
        name=folder.name,
        title=data["title"],
        build_type=data["build-type"],
        description=data["description"],
        kinds=tuple(data["kinds"]),
        languages=tuple(data.get("languages", ())),
        starts=data.get("starts", False),
        interfaces=data.get("interfaces", False),
        plugins=data.get("plugins", False),
        files=tuple(files_of(data["files"])),
        commands=tuple(data["commands"]),
        folder=folder,
    )


def files_of(rows: list[dict[str, Any]]) -> Iterator[TemplateFile]:
    for row in rows:
        yield TemplateFile(**{"path": row["source"], "about": "", **row})
