"""A test: its file, what it needs, and in CMake what builds or runs it."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator

from ..change import ChangeError
from ..package.manifest import Manifest
from ..package.package import Package
from ..scaffold.names import check_form
from ..scaffold.node_kinds import LANGUAGES, all_kinds
from ..scaffold.template import Template, TemplateFile, load_template
from ..suggest import did_you_mean
from .cmake_test import CMakeTest
from .dependency import AddedDependency
from .new_file import NewFile
from .node import NodePlace, node_place
from .part import Part
from .python_home import PythonHome, cmake_python_home, python_home
from .rendered import identifier, rendered_files
from .test_extras import TestExtras


def parts_of_test(package: Package, asked: str, force: bool = False) -> tuple[Part, ...]:
    """Return the parts of a test that was asked for as NAME[:LANGUAGE]; raises ChangeError and ScaffoldError."""
    place = node_place(package)
    name, _, language = asked.partition(":")
    name = name.removeprefix("test_")
    check_form("test", name)
    language = language or ("python" if place.build_type == "ament_python" or place.is_mostly_python else "cpp")
    if language not in LANGUAGES:
        raise ChangeError(f"there are no tests in `{language}`{did_you_mean(language, LANGUAGES)}; known: python, cpp")
    if place.build_type == "ament_python" and language == "cpp":
        raise ChangeError("a package of type ament_python has no tests in C++; leave `:cpp` out")
    return tuple(python_test(place, name, force) if language == "python" else cpp_test(place, name, force))


def python_test(place: NodePlace, name: str, force: bool) -> Iterator[Part]:
    if place.build_type == "ament_python":
        home = python_home(place.package, place.manifest)
        yield AddedDependency("python3-pytest", "test")
    else:
        home = cmake_python_home(place.cmake, place.manifest)
        yield AddedDependency("ament_cmake_pytest", "test")
    path = f"{folder_of_tests(place.package)}/test_{name}.py"
    yield NewFile(path, python_text(place, name, home), force=force)
    yield TestExtras() if place.build_type == "ament_python" else CMakeTest(name, path)


def cpp_test(place: NodePlace, name: str, force: bool) -> Iterator[Part]:
    path = f"{folder_of_tests(place.package)}/test_{name}.cpp"
    yield AddedDependency("ament_cmake_gtest", "test")
    namespace = identifier(place.manifest.name)
    headers = (f"include/{namespace}/{name}.hpp", f"src/{namespace}/{name}.hpp")
    folder = next((each.partition("/")[0] for each in headers if place.package.files.exists(each)), "")
    text = cpp_text(place, name, namespace, is_logic=bool(folder) and name in logics())
    yield NewFile(path, text, force=force)
    yield CMakeTest(name, path, folder if name in logics() else "")


def python_text(place: NodePlace, name: str, home: PythonHome) -> str:
    """Return the test of a module of ours that needs no ROS, else one that shows where tests go."""
    path = home.path(name)
    there = place.package.files.exists(path)
    if there and name in logics():
        return made(place.manifest, f"_shared/python/logic/test_{name}.py", home.module)
    module = home.module if there and has_main(place.package.files.readable_text(path)) else ""
    return made(place.manifest, "_shared/tests/test_of.py", home.module, name, module)


def cpp_text(place: NodePlace, name: str, namespace: str, *, is_logic: bool) -> str:
    if is_logic:
        return made(place.manifest, "_shared/cpp/test_logic.cpp", namespace, name)
    return made(place.manifest, "_shared/tests/test_of.cpp", namespace, name)


def made(manifest: Manifest, source: str, name: str, subject: str = "", module: str = "") -> str:
    """Return the text of one shared template."""
    path = posixpath.basename(source)
    template: Template = load_template("mixed")
    values = {"subject": subject, "module": module, "logic": subject}
    [file] = rendered_files(template, (TemplateFile(source, path, ""),), manifest, name, more=values)
    return file.entry.text.text


def logics() -> frozenset[str]:
    """Return the modules of our own kinds of nodes that need no ROS."""
    return frozenset(kind.logic for kind in all_kinds().values() if kind.logic)


def has_main(text: str) -> bool:
    try:
        return any(isinstance(node, ast.FunctionDef) and node.name == "main" for node in ast.parse(text).body)
    except (SyntaxError, ValueError):
        return False


def folder_of_tests(package: Package) -> str:
    """Return the folder of the tests: `tests` where the package has one and no `test`."""
    has = [name for name in ("test", "tests") if package.files.below(name)]
    return has[0] if has else "test"
