"""Faults of what CMake exports and generates."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.cmake_names import handed_on
from bench.faults.cmake_stop import brought_by
from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

CMAKE = r"^CMakeLists\.txt$"
NOT_LINKED = "it has programs alone, or what is loaded at run time, and nothing here links it"
LOADED = r"PLUGINLIB_EXPORT_CLASS|RCLCPP_COMPONENTS_REGISTER_NODE|(?:GZ|GAZEBO|IGNITION)_(?:REGISTER|ADD)_\w*PLUGIN"


@kind("cmake export", is_seen_outside=True)
def export_dependency_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"ament_export_dependencies\(\s*([a-z]\w+)\b"):
        is_found = is_built_against(package) or spot.word in package.words(CMAKE, r"find_package\(\s*(\w+)")
        yield spot.typo().known(is_found, "CMake finds it nowhere here, and nothing here is built against the package")


@kind("cmake export", is_seen_outside=True)
def export_dependency_lost(package: SourcePackage) -> Iterator[PutFault]:
    included = package.words(r"^include/.*\.(hpp|h)$", r"^#include\s*[<\"](\w+)/")
    is_linked = not package.holds(r"\.(cpp|cc)$", LOADED) or is_built_against(package)
    is_linked = is_linked and package.holds(CMAKE, r"add_library\(|install\(\s*DIRECTORY[^()]*\binclude\b")
    for spot in package.spots(CMAKE, r"^ament_export_dependencies\(\s*([a-z]\w+)\s*\)[ \t]*\n"):
        if spot.word in included:
            yield spot.drop().known(is_linked, NOT_LINKED)
    for spot in package.spots(
        CMAKE, r"ament_export_dependencies\([^()]*?^\s+([a-z]\w+)[ \t]*\n", 1, re.MULTILINE | re.DOTALL
    ):
        if spot.word in included:
            fault = spot.put("", spot.word)
            yield fault.known(is_linked, NOT_LINKED)


def is_built_against(package: SourcePackage) -> bool:
    """Return whether a package of the repository names another one as what it builds with."""
    folders = [folder for name, folder in package.siblings.items() if name != package.name]
    texts = [(package.repository / folder / "package.xml").read_text("utf-8", "replace") for folder in folders]
    tag = re.compile(rf"<(?:build_|build_export_)?depend\b[^>]*>\s*{re.escape(package.name)}\s*<")
    return any(tag.search(text) for text in texts)


@kind("cmake export", is_seen_outside=True)
def export_library_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    own = package.words(CMAKE, r"add_library\(\s*(\w+)")
    for spot in package.spots(CMAKE, r"ament_export_libraries\(\s*(\w+)"):
        if spot.word in own:
            yield spot.typo()


@kind("cmake export", is_seen_outside=True)
def export_targets_lost(package: SourcePackage) -> Iterator[PutFault]:
    users = [folder for name, folder in package.siblings.items() if name != package.name]
    texts = [package.repository / folder / "CMakeLists.txt" for folder in users]
    linked = re.compile(rf"(?<![\w\"]){package.name}::(?!{package.name}_node)")
    if any(linked.search(path.read_text("utf-8", "replace")) for path in texts if path.is_file()):
        for spot in package.spots(CMAKE, r"^ament_export_targets\(\s*([^()]+?)\s*\)[ \t]*\n"):
            yield spot.drop("ament_export_targets", package.name)


@kind("cmake export")
def export_target_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(CMAKE, r"ament_export_targets\(\s*(\w+)"))


@kind("interfaces")
def generation_of_interface_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^\s*\"?((?:msg|srv|action)/\w+\.(?:msg|srv|action))\"?[ \t]*\n"):
        name = spot.word.rpartition("/")[2]
        yield spot.drop(name, name.partition(".")[0])


@kind("interfaces")
def generation_dependency_lost(package: SourcePackage) -> Iterator[PutFault]:
    used = package.words(r"\.(msg|srv|action)$", r"^([a-z]\w+)/\w+")
    for name in sorted(used - {package.name, "builtin_interfaces"}):  # that one comes with most others
        pattern = rf"rosidl_generate_interfaces\([^()]*DEPENDENCIES[^()]*?(\b{name}\b)[^()]*\)"
        for spot in package.spots(CMAKE, pattern):
            others = set(re.findall(r"\w+", spot.match[0])) - {name}
            handed = (handed_on(package, each) for each in others & package.siblings.keys())
            if name not in brought_by(others).union(*handed):
                yield spot.put("", name)


@kind("interfaces")
def generation_without_found_generators(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^find_package\(\s*(rosidl_default_generators)[^)]*\)[ \t]*\n"):
        yield spot.drop("rosidl_generate_interfaces")
