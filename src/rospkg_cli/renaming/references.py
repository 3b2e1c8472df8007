"""Where the files of a workspace name a package, by the kind of each file."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..source import Source, Span
from .common import common_places
from .in_cmake import in_cmake
from .in_cpp import guards, in_cpp
from .in_interface import in_interface
from .in_manifest import in_manifest
from .in_markup import in_markup
from .in_python import in_python
from .in_setup import entry_points, in_setup_cfg
from .in_yaml import in_yaml
from .own_paths import file_names
from .patterns import found
from .renamed_package import HEADERS, RenamedPackage

CPP = (*HEADERS, ".c", ".cc", ".cpp", ".cxx", ".cu", ".in", ".em")
MARKUP = (".xml", ".launch", ".urdf", ".xacro", ".sdf", ".world", ".srdf", ".config", ".gazebo", ".rviz", ".ui")
PROSE = (".md", ".rst", ".txt", ".adoc", ".repos", ".html", ".svg", ".dox")
INTERFACES = (".msg", ".srv", ".action", ".idl")
SETUP = frozenset("setup.cfg pyproject.toml MANIFEST.in .coveragerc tox.ini mypy.ini pytest.ini colcon.pkg".split())
OURS = (r"per-package\.[\"']?%NAME%",)
META = (r"\"%NAME%\"(?=\s*:)", r"^[ \t]*%NAME%(?=\s*:)")


@dataclass(frozen=True)
class FileInWorkspace:
    """A file that holds the name: its path from the root, and from the package that it lies in."""

    path: str
    text: str
    inner: str | None
    """Relative to the package that gets the new name; None where it belongs to another."""


def places(file: FileInWorkspace, renamed: RenamedPackage, has_model: bool) -> Iterator[Span]:
    """Yield the places of the old name that mean the package; some may come twice."""
    name = file.path.rpartition("/")[2]
    source = Source(file.inner or name, file.text)
    is_own = file.inner is not None
    if name == "CMakeLists.txt" or name.endswith(".cmake"):
        yield from file_names(without_comments(file.text) if is_own else "", renamed)
        yield from common_places(without_comments(file.text), renamed, has_model)
        yield from in_cmake(Source(file.inner or file.path, file.text), renamed, is_own)
        return
    if name.endswith(PROSE):
        return
    yield from common_places(file.text, renamed, has_model)
    if is_own:
        yield from file_names(file.text, renamed)
    if name == "package.xml":
        yield from in_manifest(source, renamed, is_own)
    elif name.endswith((".py", ".pyi")) or file.text.startswith(("#!/usr/bin/env python", "#!/usr/bin/python")):
        yield from in_python(source, renamed, is_own and file.inner == "setup.py")
        if is_own and file.inner == "setup.py":
            yield from entry_points(source, renamed)
    elif name.endswith(INTERFACES):
        yield from in_interface(source, renamed)
    elif name.endswith((".yaml", ".yml", ".setup_assistant")):
        yield from in_yaml(source, renamed)
    elif name.endswith(MARKUP):
        yield from in_markup(source, renamed)
    elif name.endswith(CPP):
        yield from in_cpp(source, renamed)
    elif is_own and name in SETUP:
        yield from in_setup_cfg(source, renamed)
    elif name == "colcon.meta":
        yield from found(META, file.text, renamed.old)
    if name in ("rospkg.toml", "pyproject.toml"):
        yield from found(OURS, file.text, renamed.old)


def header_guards(file: FileInWorkspace, renamed: RenamedPackage) -> Iterator[Span]:
    """Yield the name in capitals in the guards of headers that move."""
    folder = (file.inner or "").rpartition(f"/{renamed.old}/")[0] + f"/{renamed.old}"
    is_moved = file.inner is not None and any(file.inner.startswith(f"{each}/") for each in renamed.moved)
    if is_moved and folder and file.path.endswith(HEADERS):
        yield from guards(Source(file.path, file.text), renamed)


def without_comments(text: str) -> str:
    """Return a text of CMake with blanks in the place of comments."""
    return "\n".join(line if "#" not in line else line.partition("#")[0].ljust(len(line)) for line in text.split("\n"))


def inside(path: str, package: PackageFiles) -> str | None:
    """Return a path of the root relative to a package; None where it belongs to another."""
    prefix = f"{package.folder}/" if package.folder else ""
    inner = path.removeprefix(prefix)
    return inner if path.startswith(prefix) and package.exists(inner) else None
