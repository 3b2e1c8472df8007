"""The texts of a package that may open a robot: launch files, code, pages, robots that include others."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..yaml_elsewhere import is_named_yaml

ROBOTS = (".urdf", ".xacro", ".sdf", ".world")
OPENERS = (".py", ".xml", ".launch", ".yaml", ".yml", ".cpp", ".cc", ".hpp", ".h", ".sh", ".md", ".rst", ".txt")
LAUNCH = (".py", ".xml", ".launch", ".yaml", ".yml")
YAML = (".yaml", ".yml")
INCLUDE = regex(r"(?m)^[ \t]*#[ \t]*include\b.*")
DOCSTRING = regex(r"\A(?:\s|#[^\n]*\n)*[ru]?(\"{3}|'{3})[\s\S]*?\1")


def opening_texts(files: PackageFiles, package: PackageFacts, workspace: Workspace) -> Iterator[tuple[str, str]]:
    """Yield the path and the text of each file that may open a robot; YAML that nothing names opens none."""
    for path in files.paths:
        if not path.endswith(ROBOTS + OPENERS) or path == "package.xml" or role_of(path) in ("test", "aside"):
            continue
        is_yaml = path.endswith(YAML) and role_of(path) != "launch"
        if not is_yaml or is_named_yaml(path, package, workspace):
            yield path, bare_text(files, path)


def bare_text(files: PackageFiles, path: str) -> str:
    """Return a text without comments and `#include` lines; of a Python file also without its docstring."""
    text = live_text(files, path) if path.endswith(LAUNCH + ROBOTS) else files.readable_text(path)
    return (DOCSTRING if path.endswith(".py") else INCLUDE).sub("", text, 1 if path.endswith(".py") else 0)
