"""A node: its source, what it shares with others, its executable, and what it depends on."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ..change import ChangeError
from ..light_dataclasses import dataclass, replace
from ..package.cmake.cmake_project import CMake
from ..package.manifest import Manifest
from ..package.package import Package
from ..ros.distros import Targets
from ..scaffold.cpp import libraries_of
from ..scaffold.message import is_message
from ..scaffold.node import node_of
from ..scaffold.render import RenderedFile
from ..scaffold.requested_node import RequestedNode
from ..scaffold.resolve_request import distro_of
from ..scaffold.template import Template, TemplateFile, load_template
from ..scaffold.workspace import WorkspacePackages
from .cmake_find import FoundInCMake
from .cmake_node import NodeTarget, TargetInstalled
from .cmake_python import InitFile, InstalledProgram, InstalledPythonPackage
from .dependency import AddedDependency, manifest_of
from .entry_point import ExecutableEntry
from .generated_code import GeneratedBySetup, GeneratorDeclared, IgnoredModule, generated_by_cmake
from .included import included
from .new_file import NewFile
from .part import Part
from .python_home import PythonHome, cmake_python_home, generates_interfaces, python_home
from .rendered import identifier, rendered_files
from .scripts_folder import ScriptsFolder

ANOTHER_KIND = "choose a kind of node that does without it, such as NAME:empty"


@dataclass(frozen=True)
class NodePlace:
    """A package as a place for nodes."""

    package: Package
    manifest: Manifest
    build_type: str

    @property
    def template(self) -> Template:
        """The template of our own that is most like it, its usual language first."""
        if self.build_type == "ament_python":
            return load_template("ament_python")
        mixed = load_template("mixed")
        return replace(mixed, languages=("python", "cpp")) if self.is_mostly_python else mixed

    @property
    def cmake(self) -> CMake | None:
        return self.package.parts(CMake).only

    @property
    def is_mostly_python(self) -> bool:
        """Whether CMake installs Python and builds no program and no library."""
        cmake = self.cmake
        if cmake is None or not cmake.named("ament_python_install_package"):
            return False
        return not any(target.is_built for target in cmake.targets)


def node_place(package: Package) -> NodePlace:
    """Return a package as a place for nodes; raises ChangeError where it can't have any."""
    manifest = manifest_of(package)
    build_type = manifest.build_type(Targets())
    if build_type not in ("ament_python", "ament_cmake"):
        raise ChangeError(f"packages of build type `{build_type}` get no nodes here, only ament_python and ament_cmake")
    if build_type == "ament_cmake" and package.parts(CMake).only is None:
        raise ChangeError("the package has no CMakeLists.txt that can be read; `rospkg lint` says why")
    return NodePlace(package, manifest, build_type)


def requested_node(place: NodePlace, asked: str, there: WorkspacePackages) -> RequestedNode:
    """Return the node that was asked for as NAME[:KIND[:LANGUAGE]]; raises ScaffoldError."""
    return node_of(asked, place.manifest.name, place.template, there)


def names_message(asked: str) -> bool:
    """Return whether a node is to be about a message, so that the packages around must be known."""
    return any(is_message(word) for word in asked.split(":")[1:])


def node_parts(place: NodePlace, node: RequestedNode, force: bool = False) -> tuple[Part, ...]:
    """Return the parts of a node in the order in which they are put in."""
    if node.language == "cpp":
        return tuple(cpp_parts(place, node, force))
    if place.build_type == "ament_python":
        return tuple(python_parts(place, node, force))
    return tuple(cmake_python_parts(place, node, force))


def python_needs(node: RequestedNode) -> list[str]:
    declared = ["generate_parameter_library_py"] if node.definitions else ["rcl_interfaces"] * node.declares
    return sorted({"rclpy", *node.kind.interfaces, *node.kind.modules, *declared})


def python_files(place: NodePlace, node: RequestedNode, home: PythonHome, force: bool) -> Iterator[Part]:
    """Yield the modules: what needs no ROS first."""
    if node.definitions:
        yield IgnoredModule(posixpath.join(home.folder, f"{node.definitions}.py"))
    files = node_files(place, node, home.module)
    prefix = home.module + "/"
    for file in sorted(files, key=lambda each: each.path.endswith(f"/{node.name}.py")):
        if file.path.startswith(prefix):
            path = posixpath.join(home.folder, file.path.removeprefix(prefix))
            shared = not file.path.endswith((f"/{node.name}.py", ".yaml"))
            yield new_file(path, file, rf"^\s*(?:from|import)\b.*\b{node.kind.logic}\b" if shared else "", force)


def new_file(path: str, file: RenderedFile, users: str, force: bool) -> NewFile:
    clash = ANOTHER_KIND if users else "choose another name"
    return NewFile(path, file.entry.text.text, file.entry.is_executable, clash, users, force)


def python_parts(place: NodePlace, node: RequestedNode, force: bool) -> Iterator[Part]:
    home = python_home(place.package, place.manifest)
    yield from (AddedDependency(name, "exec") for name in python_needs(node) if name != place.manifest.name)
    if node.definitions:
        yield GeneratorDeclared()
        yield GeneratedBySetup(node.definitions)
    yield from python_files(place, node, home, force)
    yield ExecutableEntry(node.name, f"{home.module}.{node.name}")
    yield ScriptsFolder(node.name)


def cmake_python_parts(place: NodePlace, node: RequestedNode, force: bool) -> Iterator[Part]:
    home = cmake_python_home(place.cmake, place.manifest)
    if generates_interfaces(place.cmake) and home.module == identifier(place.manifest.name):
        raise ChangeError(
            "CMake generates a Python package for the interfaces here, and installs one of the same name; give the "
            f"installed one another name, or choose C++, as {node.name}:{node.kind.name}:cpp"
        )
    yield AddedDependency("ament_cmake_python", "buildtool")
    compiled = included(place.package) | {each.name for each in (place.cmake.packages if place.cmake else ())}
    for name in python_needs(node):
        if name != place.manifest.name:
            yield AddedDependency(name, "all" if name in compiled else "exec")
    yield from generated_by_cmake(node)
    yield InitFile(home.folder, home.module)
    yield InstalledPythonPackage(home.module)
    yield from python_files(place, node, home, force)
    [script] = [file for file in node_files(place, node, home.module) if file.path == f"scripts/{node.name}"]
    yield new_file(script.path, script, "", force)
    yield InstalledProgram(script.path)


def cpp_parts(place: NodePlace, node: RequestedNode, force: bool) -> Iterator[Part]:
    cmake = place.cmake
    assert cmake is not None
    needs = [*libraries_of(node), *node.kind.interfaces, *(["rcl_interfaces"] if node.declares else [])]
    needs = [name for name in dict.fromkeys(needs) if name != place.manifest.name]
    yield from (AddedDependency(name, "all") for name in sorted(needs))
    yield from (FoundInCMake(name) for name in sorted(needs))
    yield from generated_by_cmake(node)
    namespace = identifier(place.manifest.name)
    library = logic_library(cmake, place.package, namespace)
    for file in sorted(node_files(place, node, namespace), key=lambda each: each.path == f"src/{node.name}.cpp"):
        path = file.path if library else re.sub(r"^include/", "src/", file.path)
        is_shared = path.endswith(".hpp")
        name = path.rpartition("/")[2]
        yield new_file(path, file, rf'include\s*"(?:{namespace}/)?{name}"' if is_shared else "", force)
    linked = library if node.kind.logic else ""
    yield NodeTarget(node, namespace, linked)
    yield TargetInstalled(f"{node.name}_component" if node.kind.name == "component" else node.name)


def logic_library(cmake: CMake, package: Package, namespace: str) -> str:
    """Return the library of headers that a package of our own has for what needs no ROS; "" where there is none."""
    target = cmake.target(cmake.project_name)
    if target is None or "INTERFACE" not in target.options:
        return ""
    return "${PROJECT_NAME}" if package.files.below(f"include/{namespace}") else ""


def node_files(place: NodePlace, node: RequestedNode, name: str) -> tuple[RenderedFile, ...]:
    """Return what the template writes for a node alone."""
    template = place.template
    wanted = tuple(file for file in template.files if is_of_nodes(file))
    return rendered_files(template, wanted, place.manifest, name, nodes=(node,), distro=distro_of("", []))


def is_of_nodes(file: TemplateFile) -> bool:
    """Return whether a file of a template is about nodes alone: their sources, and what these share."""
    return bool(file.each) or file.source.endswith("describe.hpp")
