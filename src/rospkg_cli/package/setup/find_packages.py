"""find_packages and similar functions of setuptools, and the folders of Python packages.

From setuptools' discovery.py (59.6 to 79): a package is a folder with an `__init__.py` whose name has no dot; folders
below one that is none are not looked into; what is excluded is still looked into unless `name` and `name.*` are.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from fnmatch import fnmatchcase

from ...languages.python.evaluate.conversion import NoPythonValueError, to_python
from ...languages.python.evaluate.sandbox_filesystem import MAX_DEPTH, OutsideError, SandboxFilesystem
from ...languages.python.evaluate.state import EvaluationState, Intrinsic
from ...languages.python.evaluate.values import Call, Text, Value
from ...light_dataclasses import dataclass
from ...source import Span

ALWAYS_EXCLUDED = ("ez_setup", "*__pycache__")


@dataclass(frozen=True, slots=True)
class PackageSearch:
    """One call of find_packages(): its arguments and its result."""

    path: str
    """setup.py or setup.cfg."""
    span: Span
    """Of the call."""
    where: str
    include: tuple[str, ...]
    exclude: tuple[str, ...]
    namespace: bool
    found: tuple[str, ...]
    call: Call | None = None
    """None where setup.cfg says `find:`."""

    def excludes(self, name: str) -> bool:
        return any(fnmatchcase(name, pattern) for pattern in (*ALWAYS_EXCLUDED, *self.exclude))


def finder(searches: list[PackageSearch], *, namespace: bool) -> Intrinsic:
    """Return find_packages for the evaluator; each call is added to `searches`."""

    def intrinsic(machine: EvaluationState, call: Call) -> Value | None:
        try:
            where = as_text(call, "where", 0, ".")
            exclude, include = as_texts(call, "exclude", 1, ()), as_texts(call, "include", 2, ("*",))
            inside = machine.folder.inside(where, machine.cwd)
            found = tuple(find(machine.folder, inside, include, exclude, namespace=namespace))
        except (NoPythonValueError, OutsideError, TypeError):
            return None
        searches.append(PackageSearch("setup.py", call.span, inside, include, exclude, namespace, found, call))
        return machine.computed_list(call.span, [Text(call.span, name) for name in found])

    return intrinsic


def as_text(call: Call, name: str, position: int, default: str) -> str:
    value = call.get(name, position)
    found = default if value is None else to_python(value)
    if not isinstance(found, str):
        raise NoPythonValueError
    return found


def as_texts(call: Call, name: str, position: int, default: tuple[str, ...]) -> tuple[str, ...]:
    value = call.get(name, position)
    found = default if value is None else to_python(value)
    if not isinstance(found, list | tuple | set | str) or not all(isinstance(each, str) for each in found):
        raise NoPythonValueError
    return tuple(found)


def find(
    folder: SandboxFilesystem, where: str, include: tuple[str, ...], exclude: tuple[str, ...], *, namespace: bool
) -> Iterator[str]:
    """Yield the names that setuptools finds below a folder, sorted at each level; raises OutsideError."""
    yield from below(folder, where, "", include, (*ALWAYS_EXCLUDED, *exclude), namespace)


def below(
    folder: SandboxFilesystem, at: str, dotted: str, include: tuple[str, ...], exclude: tuple[str, ...], namespace: bool
) -> Iterator[str]:
    if dotted.count(".") > MAX_DEPTH:
        raise OutsideError(f"`{at[:80]}…` lies too deep")
    for name in folder.names(at):
        path = posixpath.join(at, name)
        kind = folder.kind(path)
        if kind == "unknown" and "." not in name and (namespace or folder.may_hold_modules(path)):
            raise OutsideError(f"`{path}` is a link to a folder")
        if kind != "dir" or "." in name or not (namespace or folder.kind(f"{path}/__init__.py")):
            continue
        package = f"{dotted}.{name}" if dotted else name
        wanted = any(fnmatchcase(package, pattern) for pattern in include)
        if wanted and not any(fnmatchcase(package, pattern) for pattern in exclude):
            yield package
        if f"{package}*" not in exclude and f"{package}.*" not in exclude:
            yield from below(folder, path, package, include, exclude, namespace)


def package_folder(package: str, places: Mapping[str, str]) -> str:
    """Return where distutils looks for a package, by `package_dir` ("" for the package's own folder)."""
    head, tail = package, ""
    while head:
        if head in places:
            return posixpath.normpath(posixpath.join(places[head], tail)) if tail else places[head]
        head, _, last = head.rpartition(".")
        tail = posixpath.join(last, tail) if tail else last
    return posixpath.normpath(posixpath.join(places.get("", ""), tail)) if tail else places.get("", "")


def dotted(package: str) -> str:
    """Return the dotted name of a package; setuptools takes one with slashes, too: `my_pkg/modules`."""
    return package.replace("/", ".").rstrip(".")


def knows(searches: list[PackageSearch]) -> Mapping[str, Intrinsic]:
    """Return the functions of setuptools that the evaluator needs; what they find is added to `searches`."""
    ordinary, namespace = finder(searches, namespace=False), finder(searches, namespace=True)
    return {
        "setuptools.find_packages": ordinary,
        "setuptools.PackageFinder.find": ordinary,
        "setuptools.find_namespace_packages": namespace,
        "setuptools.PEP420PackageFinder.find": namespace,
    }
