"""Faults of what CMake builds, links and installs, of which each call is right by itself."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.cmake_names import handed_on
from bench.faults.cmake_stop import BROUGHT, brought_by
from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.known import INTERFACES
from bench.faults.source_package import SourcePackage
from rospkg_cli.ros.read_table import rows

CMAKE = r"^CMakeLists\.txt$"
CALL = r"^{}\(\s*(\$\{{PROJECT_NAME\}}|\w+)\b[^()]*\)[ \t]*\n"


def calls(package: SourcePackage, command: str) -> Iterator[Spot]:
    """Yield the calls of a command at the top level that are all there is of it for their target."""
    for spot in package.spots(CMAKE, CALL.format(command)):
        if len(re.findall(rf"{command}\(\s*{re.escape(spot.word)}\b", spot.text)) == 1:
            yield spot


def own_name(package: SourcePackage, spot: Spot) -> str:
    return package.name if spot.word == "${PROJECT_NAME}" else spot.word


@kind("cmake targets")
def target_source_lost(package: SourcePackage) -> Iterator[PutFault]:
    """A source that registers a node or a plugin is no longer compiled."""
    for spot in package.spots(CMAKE, r"^\s+((?:[\w-]+/)*([\w-]+\.cpp))[ \t]*\n(?=[^()]*\))"):
        loaded = r"RCLCPP_COMPONENTS_REGISTER_NODE|PLUGINLIB_EXPORT_CLASS"
        if package.holds(rf"^{re.escape(spot.word)}$", loaded):
            yield spot.drop(spot[2])


@kind("cmake targets")
def target_links_lost(package: SourcePackage) -> Iterator[PutFault]:
    """Nothing of ROS is linked any more to what includes it."""
    for spot in calls(package, "ament_target_dependencies"):
        if not package.holds(CMAKE, rf"target_link_libraries\(\s*{re.escape(spot.word)}\b|ament_auto"):
            found = re.findall(r"[a-z]\w+", spot.match[0])[1:]
            fault = spot.drop(own_name(package, spot), *found)
            yield fault.known(includes(package, spot, found), "no source of the target includes any of them")


def includes(package: SourcePackage, spot: Spot, names: list[str]) -> bool:
    """Return whether the sources of a target, and the headers that they may include, include any package."""
    made = re.search(rf"add_(?:executable|library)\(\s*{re.escape(spot.word)}\b([^()]*)\)", spot.text)
    sources = "|".join(re.escape(each) for each in made[1].split() if "." in each) if made else ""
    start = rf"^#include\s*[<\"](?:{'|'.join(names)})[/_]"
    headers = rf"^#include\s*[<\"](?:\.\./|include/|{package.name}/)"
    files = rf"^(?:{sources})$" if sources and made and "$" not in made[1] else r"\.(cpp|cc)$"
    return package.holds(files, start) or (package.holds(files, headers) and package.holds(r"\.hp?p?$", start))


@kind("cmake targets")
def target_dependency_lost(package: SourcePackage) -> Iterator[PutFault]:
    """One package that the sources of the only target include is not linked."""
    targets = list(package.spots(CMAKE, r"^\s*add_(?:executable|library)\(\s*([\w${}]+)"))
    package_name = r"(\"?(sensor_msgs|nav_msgs|std_srvs|cv_bridge)\"?)"
    pattern = rf"^ament_target_dependencies\([^()]*?(?<=\s){package_name}(?=[\s)])[^()]*\)"
    for spot in package.spots(CMAKE, pattern) if len(targets) == 1 else ():
        others = set(re.findall(r"[a-z]\w+", re.sub(r"^\w+\(\s*\S+", "", spot.match[0]))) - {spot[2]}
        known = {*package.siblings, *INTERFACES, *BROUGHT, *rows("exported_dependencies.txt")}
        is_known = others <= known
        if package.holds(r"^(src|include)/.*\.(cpp|hpp)$", rf"#include\s*[<\"]{spot[2]}/"):
            brought = brought_by(others).union(*(handed_on(package, each) for each in others & package.siblings.keys()))
            if spot[2] not in brought:
                yield spot.put("", spot[2]).known(is_known, "a package that is not here may bring it")


@kind("cmake targets")
def target_include_folder_lost(package: SourcePackage) -> Iterator[PutFault]:
    """The package's own headers are not found."""
    own = package.matching(r"^include/.*\.hp?p?$")
    places = [
        *calls(package, "target_include_directories"),
        *package.spots(CMAKE, r"^(include_directories)\([^()]*\)\n"),
    ]
    if own and len(places) == 1 and package.holds(r"^src/.*\.cpp$", rf"#include\s*[<\"]{package.name}/"):
        yield places[0].drop("include", own_name(package, places[0]), *(each.rpartition("/")[2] for each in own))


@kind("cmake targets")
def target_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^(add_executable\(\s*(\w+)[^()]*\))[ \t]*\n"):
        yield spot.put(f"{spot.word}\n{spot.word}", spot[2])


@kind("cmake targets")
def target_of_library_not_installed(package: SourcePackage) -> Iterator[PutFault]:
    """The library of a component or a plugin stays in the build folder."""
    for spot in package.spots(CMAKE, r"^install\(\s*TARGETS\s+(\w+)\s[^()]*\)[ \t]*\n"):
        registered = rf"rclcpp_components_register_nodes?\(\s*{spot.word}\b"
        if package.holds(CMAKE, registered) and f"add_library({spot.word}" in spot.text:
            yield spot.drop()


@kind("cmake targets")
def target_before_it_is_made(package: SourcePackage) -> Iterator[PutFault]:
    """What links a target stands above what makes it."""
    pattern = r"^(add_executable\(\s*(\w+)[^()]*\)\n)\s*(ament_target_dependencies\(\s*\2[^()]*\)\n)"
    for spot in package.spots(CMAKE, pattern):
        before, after = spot.match.start(), spot.match.end()
        text = spot.text[:before] + spot[3] + spot[1] + spot.text[after:]
        yield spot.rewritten(text, spot[2])


@kind("cmake targets")
def script_without_interpreter(package: SourcePackage) -> Iterator[PutFault]:
    """A program in Python does not begin with `#!` any more."""
    installed = package.words(CMAKE, r"install\(\s*PROGRAMS[^()]*?([\w./-]+\.py)\b(?=[^()]*DESTINATION\s+lib/)")
    for file in sorted(installed & set(package.files)):
        for spot in package.spots(rf"^{re.escape(file)}$", r"\A()#!", 0):
            line = spot.text.find("\n") + 1
            text = spot.text[line:]
            if not re.match(r"#!", text):
                yield spot.rewritten(text, file.rpartition("/")[2])


@kind("cmake targets")
def script_without_executable_bit(package: SourcePackage) -> Iterator[PutFault]:
    """`colcon build --symlink-install` links a program that is not executable; one of another name is a copy."""
    is_linked = r"(?![^()]*\b(?:RENAME|PERMISSIONS)\b)"
    for spot in package.spots(CMAKE, rf"install\(\s*PROGRAMS\s+([\w./-]+\.py)\s+DESTINATION\s+lib/{is_linked}"):
        if spot.word in package.files:
            path = package.path(spot.word)
            yield PutFault(path, (spot.word.rpartition("/")[2],), {path: package.data(spot.word)}, 0, frozenset({path}))


@kind("cmake targets")
def cmake_minimum_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^(cmake_minimum_required)\([^()]*\)[ \t]*\n"):
        yield spot.drop("cmake_minimum_required")
