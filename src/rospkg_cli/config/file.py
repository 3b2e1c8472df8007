"""The user's config: the nearest rospkg.toml, else [tool.rospkg] in pyproject.toml. It loads no code."""

from __future__ import annotations

import io
import os
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from ..current_folder import absolute, current_folder
from ..disk_trace import is_file, read_limited
from ..light_dataclasses import dataclass, field
from .schema import FORMS, key_position, read_section
from .schema import ConfigError as ConfigError

Keys = tuple[str, ...]
"""The keys that lead to a value from the top of the config: ("per-path", "src/*", "ignore", "XML104")."""

MAX_TEXT = 1_000_000
"""Characters; the largest pyproject.toml that is known has a tenth of it."""

MAX_PARTS = 100
"""Of a key: `a.b` has two."""

Ignores = Mapping[str, str]
"""Code, name or prefix → the reason."""


@dataclass(frozen=True)
class OverrideSection:
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
    """The TOML table of our keys in that file."""
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
    per_package: tuple[OverrideSection, ...] = ()
    per_path: tuple[OverrideSection, ...] = ()
    new: Mapping[str, Any] = field(default_factory=dict)
    index: Mapping[str, Any] = field(default_factory=dict)
    """Where names are fetched from; only allowed in the user's config."""

    @property
    def folder(self) -> Path:
        """The folder that its patterns are relative to."""
        return self.path.parent if self.path else current_folder()


def find_config(start: Path) -> Config:
    """Return the config that applies to a path; raises ConfigError, with line and column, where it is wrong."""
    start = absolute(start)
    for folder in (start, *start.parents):
        for path, table in config_files(folder):
            return load_config(path, table)
    return Config()


def config_files(folder: Path) -> Iterator[tuple[Path, tuple[str, ...]]]:
    if is_file(folder / "rospkg.toml"):
        yield folder / "rospkg.toml", ()
    pyproject = folder / "pyproject.toml"
    if is_file(pyproject) and "[tool.rospkg" in read_config_text(pyproject):
        yield pyproject, ("tool", "rospkg")


def user_config() -> Config:
    """Return the user's config, for keys that a repository may not set; raises ConfigError."""
    path = user_config_path()
    return load_config(path, own=True) if is_file(path) else Config()


def user_config_path() -> Path:
    return Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "rospkg" / "config.toml"


def load_config(path: Path, table: tuple[str, ...] = (), own: bool = False) -> Config:
    """Read a config file; `table` names the TOML table of our keys, `own` says whether it is the user's config."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib

    text = read_config_text(path)
    if len(text) > MAX_TEXT:
        raise ConfigError(f"{path}: a config of more than {MAX_TEXT:,} characters is not read")
    refuse_long_keys(text, path)
    try:
        data: Any = tomllib.loads(text)
    except RecursionError:
        raise ConfigError(f"{path}: it is nested too deeply") from None
    except ValueError as error:  # also a number of more digits than Python reads
        raise ConfigError(f"{path}: not valid TOML: {error}") from None
    for key in table:
        data = data.get(key, {}) if isinstance(data, dict) else data
    values = read_section(data, FORMS, path, text, table)
    if "index" in values and not own:
        where = key_position(path, text, table, "index")
        raise ConfigError(
            f"{where}: `index` belongs in {user_config_path()}: no repository says where your names come from"
        )
    for key in PER:
        values[key] = tuple(OverrideSection(key, name, **each) for name, each in values.get(key, {}).items())
    return Config(path, table, **{key.replace("-", "_"): value for key, value in values.items()})


def refuse_long_keys(text: str, path: Path) -> None:
    """Raise ConfigError for a key of very many parts: Python takes time for it that grows with their square."""
    for number, line in enumerate(text.split("\n"), 1):
        if line.count(".") > MAX_PARTS:
            before = (re.split(r"[{,]", part)[-1] for part in re.split("[=\\]]", line))
            if any(part.count(".") > MAX_PARTS and "#" not in part for part in before):
                raise ConfigError(f"{path}:{number}:1: a key of more than {MAX_PARTS} parts is not read")


def read_config_text(path: Path) -> str:
    """Return as much of a file as can be a config, and one character; raises ConfigError."""
    try:
        data = read_limited(path)[1]
    except OSError as error:
        raise ConfigError(f"{path}: it can't be read: {error.strerror or error}") from None
    if data is None:
        return " " * (MAX_TEXT + 1)
    return io.TextIOWrapper(io.BytesIO(data), encoding="utf-8", errors="replace").read(MAX_TEXT + 1)


PER = ("per-package", "per-path")
