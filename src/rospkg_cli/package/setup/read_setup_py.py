"""Evaluate setup.py where it is what colcon runs."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.python.evaluate.evaluator import Evaluator
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.values import Call, Unknown
from ...languages.python.file import parse_python
from ...lazy_regex import regex
from ...source import Span
from ...unreadable import UnreadableError
from ..manifest import Manifest
from .find_packages import PackageSearch, knows
from .setup_cfg import SetupCfg
from .setup_py import SetupPy

LEFT_TO_SETUP = regex(r"\ndynamic\s*=\s*\[[^\]]*['\"](?:scripts|entry-points)['\"]")
"""Where pyproject.toml says that setup.py has the entry points."""
ASKS_WHERE = regex(r"__file__|cwd|path\b.*\(|resolve|absolute")
"""Parts of code that may read the path of its own folder, and so its name."""


def read_setup_py(reading: ReaderInput) -> Iterator[SetupPy]:
    """Evaluate setup.py where it is what colcon runs; raises UnreadableError where it is no Python."""
    if not reading.files.exists("setup.py") or not runs_setup_py(reading):
        return
    file = parse_python(reading.files.source("setup.py"))
    searches: list[PackageSearch] = []
    folder = SandboxFilesystem(reading.files)
    evaluator = Evaluator(file, folder, knows(searches))
    evaluator.run_file()
    cfg = reading.parts(SetupCfg)
    call, call_unknown = setup_call(evaluator)
    if call is not None and ASKS_WHERE.search(file.source.text):
        from ...languages.python.evaluate.folder_names import without_folder_names  # few setup.py ask where they are

        call = without_folder_names(call)
    yield SetupPy(
        file=file,
        folder=folder,
        call=call,
        call_unknown=call_unknown,
        cfg=cfg.only,
        cfg_broken=bool(cfg.broken) or has_project_table(reading),
        calls=tuple(evaluator.calls),
        globs=tuple(evaluator.globs),
        searches=tuple(searches),
        names=evaluator.scope.names,
        cwd=evaluator.cwd,
    )


def runs_setup_py(reading: ReaderInput) -> bool:
    """Return whether the package is built with its setup.py: by its build type, or without one and without CMake."""
    manifest = reading.parts(Manifest).only
    types = {element.text for element in manifest.exports if element.tag == "build_type"} if manifest else set()
    return "ament_python" in types or (not types and not reading.files.exists("CMakeLists.txt"))


def has_project_table(reading: ReaderInput) -> bool:
    """Return whether pyproject.toml gives metadata, or can't be read and may.

    It leaves scripts to setup.py where it says so. A table for setuptools may say more.
    """
    if not reading.files.exists("pyproject.toml"):
        return False
    try:
        text = "\n" + reading.files.source("pyproject.toml").text
    except UnreadableError:
        return True
    is_left = LEFT_TO_SETUP.search(text) is not None and "\n[tool.setuptools" not in text
    return "\n[project]" in text and not is_left


def setup_call(evaluator: Evaluator) -> tuple[Call | None, Unknown | None]:
    """Return the one call of setup(), or why there is none to rely on."""
    found = [call for call in evaluator.calls if call.callee.rpartition(".")[2] == "setup" and call.receiver is None]
    if len(found) == 1 and found[0].is_certain:
        return found[0], None
    why = evaluator.gave_up or ("setup() is not called" if not found else "which setup() is called can't be determined")
    return None, Unknown(found[0].span if found else Span(0, 0), why)
