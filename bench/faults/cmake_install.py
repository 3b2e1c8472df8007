"""Faults of what CMake installs, exports and generates."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

CMAKE = r"^CMakeLists\.txt$"
USED_FOLDERS = r"(?:launch|config|urdf|meshes|rviz|params|maps|worlds|models|robots)"


@kind("cmake install")
def install_of_target_lost(package: SourcePackage) -> Iterator[PutFault]:
    executables = package.words(CMAKE, r"add_executable\(\s*(\w+)")
    for spot in package.spots(CMAKE, r"install\(\s*TARGETS\s+[^()]*?\b(\w+)\b(?=[^()]*DESTINATION\s+\"?lib/)"):
        if spot.word in executables:
            yield spot.put("", spot.word)


@kind("cmake install")
def install_of_mistyped_target(package: SourcePackage) -> Iterator[PutFault]:
    own = package.words(CMAKE, r"add_(?:executable|library)\(\s*(\w+)")
    for spot in package.spots(CMAKE, r"install\(\s*TARGETS\s+(\w+)"):
        if spot.word in own:
            yield spot.typo()


@kind("cmake install")
def install_of_folder_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, rf"^\s*({USED_FOLDERS})/?[ \t]*\n(?=[^()]*DESTINATION share)"):
        if package.holds(CMAKE, rf"install\(\s*DIRECTORY[^()]*\b{spot.word}\b") and package.matching(rf"^{spot.word}/"):
            yield spot.drop()


@kind("cmake install")
def install_of_one_folder_lost(package: SourcePackage) -> Iterator[PutFault]:
    pattern = rf"^install\(\s*DIRECTORY\s+({USED_FOLDERS})/?\s+DESTINATION\s+share[^()]*\)[ \t]*\n"
    for spot in package.spots(CMAKE, pattern):
        if package.matching(rf"^{spot.word}/(?!.*\.launch$)"):  # a bare one is mostly ROS 1's
            again = package.holds(CMAKE, rf"INSTALL_TO_SHARE[^()]*\b{spot.word}\b")
            yield spot.drop().known(not (package.is_python or again), "another call installs it, or nobody reads this")


@kind("cmake install")
def install_of_mistyped_folder(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, rf"install\(\s*DIRECTORY[^()]*?\b({USED_FOLDERS})\b(?=[^()]*DESTINATION share)"):
        if package.matching(rf"^{spot.word}/"):
            yield spot.typo()


@kind("cmake install")
def install_into_share_alone(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(
        CMAKE, rf"install\(\s*DIRECTORY\s+({USED_FOLDERS})[^()]*DESTINATION\s+share(/\$\{{PROJECT_NAME\}})", 2
    ):
        yield spot.put("", spot[1], "share")


def executables_in(package: SourcePackage, spot: Spot) -> list[str]:
    """Return the executables whose whole names an install rule holds."""
    names = package.words(CMAKE, r"add_executable\(\s*([\w${}]+)")
    whole = (name for name in sorted(names) if re.search(rf"(?<![\w}}]){re.escape(name)}(?![\w$])", spot.match[0]))
    named = (name.replace("${PROJECT_NAME}", package.name) for name in whole)
    return [name for name in named if "$" not in name]


def is_for_libraries(spot: Spot) -> bool:
    """Return whether the last destination is one of libraries: programs go to bin/ then, before and after."""
    return re.search(r"\b(?:ARCHIVE|LIBRARY)\b(?![\s\S]*\bRUNTIME\b)", spot.match[0]) is not None


@kind("cmake install")
def install_of_executable_into_bin(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"install\(\s*TARGETS[^()]*?(\w+)[^()]*DESTINATION\s+(lib/\$\{PROJECT_NAME\})", 2):
        inside = executables_in(package, spot)
        if inside and not is_for_libraries(spot) and "RUNTIME" not in spot.match[0]:
            yield spot.put("bin", *inside)


@kind("cmake install")
def install_of_executable_into_lib(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"install\(\s*TARGETS[^()]*DESTINATION\s+lib(/\$\{PROJECT_NAME\})"):
        inside = executables_in(package, spot)
        if inside and not is_for_libraries(spot):
            yield spot.put("", *inside)


@kind("cmake install")
def install_into_absolute_share(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"DESTINATION\s+()share/\$\{PROJECT_NAME\}"):
        yield spot.put("/", "/share/${PROJECT_NAME}")


@kind("cmake install")
def install_of_mistyped_program(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"install\(\s*PROGRAMS[^()]*?\b(\w+\.py)\b"):
        if package.matching(rf"(^|/){spot.word}$"):
            yield spot.typo()


@kind("cmake install")
def install_of_program_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^\s+([\w/]+\.py)[ \t]*\n(?=[^()]*DESTINATION\s+lib)"):
        is_ros1 = package.holds(rf"(^|/){re.escape(spot.word)}$", r"^import rospy")
        is_there = spot.word in package.files
        if is_there and package.holds(CMAKE, rf"install\(\s*PROGRAMS[^()]*{spot.word}") and not is_ros1:
            runs = package.holds(rf"^{re.escape(spot.word)}$", r"\A#!|__name__|^(?:main|rclpy\.\w+)\(")
            yield spot.drop(spot.word.rpartition("/")[2]).known(runs, "it runs nothing: other code imports it")


@kind("cmake install")
def programs_as_files(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"install\(\s*(PROGRAMS)\s+([\w/.]+)[^()]*DESTINATION\s+lib"):
        yield spot.put("FILES", spot[2].rpartition("/")[2])


@kind("cmake install")
def script_not_executable_in_directory(package: SourcePackage) -> Iterator[PutFault]:
    """No bit on a script that `install(DIRECTORY … USE_SOURCE_PERMISSIONS)` puts into lib/."""
    for spot in package.spots(
        CMAKE, r"install\(\s*DIRECTORY\s+(\w+)/?\s[^()]*DESTINATION\s+lib/[\w${}]+\s+USE_SOURCE_PERMISSIONS"
    ):
        for file in package.matching(rf"^{spot.word}/\w+\.py$"):
            path = package.path(file)
            yield PutFault(path, (file.rpartition("/")[2],), {path: package.data(file)}, 0, frozenset({path}))


@kind("cmake install")
def python_package_not_installed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^\s*(ament_python_install_package)\([^)]*\)[ \t]*\n"):
        files = package.matching(rf"^(src/)?{package.name}/(?!__init__).*\.py$")
        programs = package.words(CMAKE, r"([\w-]+\.py)\b")
        modules = [each for each in files if each.rpartition("/")[2] not in programs]
        yield spot.drop(package.name).known(bool(modules), "the Python package holds no module but programs")


@kind("cmake install")
def python_package_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"ament_python_install_package\((?:\$\{PROJECT_NAME\}|(\w+))\s*\)", 0):
        yield spot.put("ament_python_install_package(my_modules)", "my_modules")


@kind("cmake install")
def ament_package_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.drop() for spot in package.spots(CMAKE, r"^(ament_package)\([^)]*\)[ \t]*\n?"))


@kind("cmake install")
def ament_package_too_early(package: SourcePackage) -> Iterator[PutFault]:
    if not package.holds(CMAKE, r"^\s*find_package\(\s*ament"):
        return  # CMake stops before
    pattern = r"^(ament_export_\w+\([^()]*\))(?=.*\n(ament_package\([^)]*\)))"
    for spot in package.spots(CMAKE, pattern, 1, re.MULTILINE | re.DOTALL):
        text = spot.text.replace(f"\n{spot[2]}", "\n", 1).replace(spot.word, f"{spot[2]}\n{spot.word}", 1)
        yield PutFault(spot.path, ("ament_package",), {spot.path: text.encode()})
        return


@kind("cmake install", is_seen_outside=True)
def headers_not_installed(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^install\(\s*DIRECTORY\s+\"?(include)/?\"?\s[^()]*\)[ \t]*\n"
    exports = package.holds(CMAKE, r"ament_export_(?:include_directories|libraries|targets|interfaces)|ament_auto_")
    if package.matching(r"^include/.*\.hp?p?$"):
        for spot in package.spots(CMAKE, pattern):
            yield spot.drop().known(exports, "nothing exports the headers")
