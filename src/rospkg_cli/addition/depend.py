"""A dependency that was asked for: where it is used says under which tag, and whether CMake has to know it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ..change import ChangeError
from ..package.cmake.cmake_project import CMake
from ..package.manifest import Manifest
from ..package.package import Package
from ..ros.distros import Targets
from ..ros.manifest import DEPENDENCY_TAGS, is_buildtool
from ..scaffold.resolve_request import TEST_ONLY, depends_of
from ..suggest import did_you_mean
from .cmake_find import FoundInCMake
from .cmake_link import Linked
from .dependency import AddedDependency, Need, manifest_of
from .included import CPP, included, includes_of
from .named import code_of, is_code
from .part import Part

TEST_TOOLS = re.compile(
    r"ament_cmake_(gtest|gmock|pytest|google_benchmark|copyright|cppcheck|cpplint|flake8|lint_cmake|mypy|pep257|"
    r"uncrustify|xmllint|black|clang_format)|ros_testing|launch_pytest"
)


def depend_parts(package: Package, keys: Iterable[str], tag: str = "") -> tuple[Part, ...]:
    """Return the parts of dependencies; raises ChangeError for a tag, ScaffoldError for a key that can't be one."""
    if tag and tag not in DEPENDENCY_TAGS:
        hint = did_you_mean(tag, DEPENDENCY_TAGS)
        raise ChangeError(f"package.xml has no tag <{tag}>{hint}; known: {', '.join(DEPENDENCY_TAGS)}")
    manifest = manifest_of(package)
    runs, tests = depends_of(tuple(keys), manifest.name)
    return tuple(part for key in sorted({*runs, *tests}) for part in parts_of(package, manifest, key, tag))


def parts_of(package: Package, manifest: Manifest, key: str, tag: str) -> Iterator[Part]:
    need = need_of(package, manifest, key)
    yield AddedDependency(key, need, tag)
    cmake = package.parts(CMake).only
    if cmake is not None and key in included(package) and manifest.build_type(Targets()) == "ament_cmake":
        yield FoundInCMake(key)
        yield from (Linked(target, key) for target in targets_with(package, cmake, key))


def need_of(package: Package, manifest: Manifest, key: str) -> Need:
    """Return when a package needs another: as its files say, else as is usual for its build type."""
    if TEST_ONLY.fullmatch(key) or TEST_TOOLS.fullmatch(key):
        return "test"
    if is_buildtool(key):
        return "buildtool"
    users = files_naming(package, key)
    if users and all(path.startswith(("test/", "tests/")) for path in users):
        return "test"
    if manifest.build_type(Targets()) == "ament_python" or key.startswith("python3-"):
        return "exec"
    if any(path.endswith(CPP) for path in users) or not users:
        return "all" if builds_code(package) else "exec"
    return "all" if any(path.endswith((".msg", ".srv", ".action")) for path in users) else "exec"


def builds_code(package: Package) -> bool:
    """Return whether CMake compiles something, or generates interfaces."""
    cmake = package.parts(CMake).only
    return cmake is not None and (any(target.is_built for target in cmake.targets) or bool(cmake.interface_targets))


def files_naming(package: Package, key: str) -> list[str]:
    """Return the files of a package that name another one outside of comments."""
    word = re.compile(rf"(?<![\w-]){re.escape(key)}(?![\w-])")
    paths = [path for path in package.files.paths if is_code(path) and not path.endswith((".cmake", "CMakeLists.txt"))]
    return [path for path in paths if word.search(code_of(package, path, key))]


def targets_with(package: Package, cmake: CMake, key: str) -> Iterator[str]:
    """Yield the targets whose own sources include a header of a package."""
    for target in cmake.targets:
        paths = [word.text for word in target.sources if package.files.exists(word.text)]
        built = target.is_built and not target.call.testing and not target.call.maybe
        if built and any(key in includes_of(package, path) for path in paths):
            yield target.name
