"""Run one setup.py with a setup() that only writes down what it is given.  Started by setup_truth.py, in a sandbox.

    record_setup.py FOLDER OUTPUT

Modules that can't be imported are replaced by stubs; OUTPUT gets a JSON object: `options` (what setuptools makes of the
arguments and of setup.cfg), `stubs` (the modules that were replaced), or `error`.
"""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.machinery
import json
import os
import runpy
import sys
import types
from collections.abc import Sequence
from pathlib import Path
from typing import Any

STUBS: list[str] = []


class Stub(types.ModuleType):
    """A module of which every attribute is a function that does nothing."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *args, **named: Stub(name)


class Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """The last resort of the import system."""

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: types.ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        STUBS.append(name)
        return importlib.machinery.ModuleSpec(name, self, is_package=True)

    def create_module(self, spec: importlib.machinery.ModuleSpec) -> types.ModuleType:
        return Stub(spec.name)

    def exec_module(self, module: types.ModuleType) -> None:
        """There is nothing to execute."""


def recorded(attributes: dict[str, Any]) -> dict[str, Any]:
    """Return what setuptools makes of the arguments, together with setup.cfg."""
    Distribution: Any = importlib.import_module("setuptools").Distribution
    given = {key: value for key, value in attributes.items() if key not in ("cmdclass", "setup_requires")}
    distribution = Distribution(given)
    distribution.parse_config_files()
    fields = ("packages", "py_modules", "scripts", "package_dir", "data_files", "entry_points")
    options = {field: getattr(distribution, field, None) for field in fields}
    options["name"], options["version"] = distribution.metadata.name, distribution.metadata.version
    return options


def main(folder: str, output: str) -> None:
    seen: list[dict[str, Any]] = []
    result: dict[str, Any] = {}
    os.chdir(folder)
    setuptools: Any = importlib.import_module("setuptools")
    core: Any = importlib.import_module("distutils.core")

    def record(*args: object, **attributes: Any) -> Stub:
        seen.append(attributes)
        return Stub("distribution")

    setuptools.setup = core.setup = record
    sys.meta_path.append(Finder())
    sys.path.insert(0, folder)
    sys.argv = ["setup.py", "--name"]
    try:
        runpy.run_path(str(Path(folder, "setup.py")), run_name="__main__")
    except BaseException as error:  # whatever a stranger's setup.py raises is a result
        result["error"] = f"{type(error).__name__}: {error}"
    sys.meta_path.pop()
    if len(seen) == 1:
        try:
            result["options"] = recorded(seen[0])
        except Exception as error:
            result["error"] = f"{type(error).__name__}: {error}"
    result["calls"], result["stubs"] = len(seen), sorted(set(STUBS))
    Path(output).write_text(json.dumps(result, default=str), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
