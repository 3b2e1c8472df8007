"""The user's config: the nearest rospkg.toml, else [tool.rospkg] in pyproject.toml. It loads no code."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .configkeys import FORMS, place, read_section
from .configkeys import ConfigError as ConfigError
from .here import absolute, here

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

Ignores = Mapping[str, str]
"""Code, name or prefix → the reason."""


@dataclass(frozen=True)
class Section:
    """Ignores and severities for the packages or paths that a pattern fits."""

    key: str
    """per-package or per-path."""
    pattern: str
    ignore: Ignores = field(default_factory=dict)
    severity: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Config:
    path: Path | None = None
    """The file it came from; None for no config."""
    table: tuple[str, ...] = ()
    """Where in that file our keys stand."""
    select: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    ignore: Ignores = field(default_factory=dict)
    severity: Mapping[str, str] = field(default_factory=dict)
    target: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    build_types: tuple[str, ...] = ()
    plugins: tuple[str, ...] = ()
    pedantic: bool = False
    release: bool = False
    fail_on: str = "warning"
    required_version: str = ""
    per_package: tuple[Section, ...] = ()
    per_path: tuple[Section, ...] = ()
    new: Mapping[str, Any] = field(default_factory=dict)
    index: Mapping[str, Any] = field(default_factory=dict)
    """Where names are fetched from; in the user's own config alone."""

    @property
    def folder(self) -> Path:
        """The folder that its patterns are relative to."""
        return self.path.parent if self.path else here()


def find_config(start: Path) -> Config:
    """Return the config that holds for a path; raises ConfigError with line and column for what is wrong in it."""
    start = absolute(start)
    for folder in (start, *start.parents):
        for path, table in candidates(folder):
            return load(path, table)
    return Config()


def candidates(folder: Path) -> Iterator[tuple[Path, tuple[str, ...]]]:
    if (folder / "rospkg.toml").is_file():
        yield folder / "rospkg.toml", ()
    pyproject = folder / "pyproject.toml"
    if pyproject.is_file() and "[tool.rospkg" in pyproject.read_text("utf-8", "replace"):
        yield pyproject, ("tool", "rospkg")


def own_config() -> Config:
    """Return the user's own config, for what no repository can say; raises ConfigError."""
    path = own_path()
    return load(path, own=True) if path.is_file() else Config()


def own_path() -> Path:
    return Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "rospkg" / "config.toml"


def load(path: Path, table: tuple[str, ...] = (), own: bool = False) -> Config:
    """Read a config file; `table` is where in it our keys stand, `own` whether it is the user's own."""
    text = path.read_text("utf-8", "replace")
    try:
        data: dict[str, Any] = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ConfigError(f"{path}: not valid TOML: {error}") from None
    for key in table:
        data = data.get(key, {})
    values = read_section(data, FORMS, path, text, table)
    if "index" in values and not own:
        where = place(path, text, table, "index")
        raise ConfigError(f"{where}: `index` belongs in {own_path()}: no repository says where your names come from")
    for key in PER:
        values[key] = tuple(Section(key, name, **each) for name, each in values.get(key, {}).items())
    return Config(path, table, **{key.replace("-", "_"): value for key, value in values.items()})


PER = ("per-package", "per-path")
