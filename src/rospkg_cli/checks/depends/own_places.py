"""Libraries that CMake looks for in a folder of its own, where no package manager puts them (DEP104 and others)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.cmake.evaluated_command import path_in_package
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ...package.cmake.find_package import FoundPackage
from ...ros.libraries import stem

WORDS = ("HINTS", "PATHS", "NO_DEFAULT_PATH")
"""Behind one of these keywords `find_package()` names folders to look into."""
OF_SYSTEM = ("/usr/share", "/usr/lib", "/usr/include", "/usr/cmake", "/opt/ros")
"""Where package managers put libraries."""
OWN = regex(r"\$\{(?:CMAKE_CURRENT_LIST_DIR|(?:CMAKE|PROJECT|CMAKE_CURRENT)_SOURCE_DIR|CMAKE_HOME_DIRECTORY)\}")
"""The folder of a file, or of the project, in a module that looks for a library."""
LISTS = ("CMAKE_PREFIX_PATH", "CMAKE_LIBRARY_PATH", "CMAKE_INCLUDE_PATH", "ENV{PKG_CONFIG_PATH}")
FETCHING = ("cpmaddpackage", "cpmfindpackage", "file", "execute_process", "add_custom_command", "add_custom_target")
TOOL = regex(r"(?:^|/)(?:git|wget|curl|make|ninja|conan|vcpkg|tar|unzip|[^/\s]+\.(?:sh|bash|py))(?:\s|$)")
"""A program that brings sources, or builds them."""
LINKING = ("target_link_libraries", "link_libraries", "target_link_options", "add_link_options")
LINKER_FLAGS = regex(r"LINKER_FLAGS|LINK_FLAGS")
FOLDER = regex(r"(?:^|\s)-L[^\s]")
OF_VARIABLE = regex(r"\$(?:ENV)?\{\w*(?:ROOT|HOME|PATH|PREFIX|SDK|DIR)\}/")
"""The beginning of a folder in one that people set, and that no command finds: `${SDK_ROOT}/include`."""
ELSEWHERE = "; CMake looks for it in a folder that is named here, where it may lie by other ways"


def looks_elsewhere(found: FoundPackage, cmake: CMake) -> bool:
    """Return whether a library may lie in a folder that the package names, or has, for it."""
    texts = found.call.texts
    hints = texts[min((texts.index(word) for word in WORDS if word in texts), default=len(texts)) :]
    names = {f"{found.name}_DIR", f"{found.name}_ROOT", "CMAKE_PREFIX_PATH"}
    sets = (call.texts[1:] for call in cmake.named("set") if call.texts[:1] and call.texts[0] in names)
    lists = (call.texts[2:] for call in cmake.named("list") if list(call.texts[1:2]) == ["CMAKE_PREFIX_PATH"])
    return any(map(names_places, (hints, *sets, *lists))) or has_module(found.name, cmake)


def names_places(words: Sequence[str]) -> bool:
    """Return whether some words name a folder outside of those of the system."""
    return any(word not in WORDS and not word.startswith(OF_SYSTEM) for word in words)


def has_module(name: str, cmake: CMake) -> bool:
    """Return whether the package has a module `FindX.cmake` that looks into folders of the package."""
    files = cmake.package_files
    paths = (path for path in files.paths if path.rpartition("/")[2] == f"Find{name}.cmake")
    return any(OWN.search(files.readable_text(path)) for path in paths)


def fetching_words(cmake: CMake) -> Iterator[str]:
    """Yield the words of commands that fetch or build something by themselves: `execute_process(COMMAND git …)`."""
    for call in cmake.named(*FETCHING):
        is_fetch = call.name.startswith("cpm") or any(map(TOOL.search, call.texts))
        if is_fetch or (call.name == "file" and call.texts[:1] == ("DOWNLOAD",)):
            yield from call.texts


def searched_places(cmake: CMake) -> bool:
    """Return whether CMake has a list of folders, none of the system, in which it looks for libraries first."""
    sets = (call.texts[1:] for call in cmake.named("set") if call.texts[:1] and call.texts[0] in LISTS)
    lists = (call.texts[2:] for call in cmake.named("list") if call.texts[1:2] and call.texts[1] in LISTS)
    return any(words and names_places(words) for words in (*sets, *lists))


def has_linker_folders(cmake: CMake) -> bool:
    """Return whether CMake gives the linker folders, in any way: `-L/opt/x/lib`, link_directories()."""
    if cmake.named("link_directories", "target_link_directories"):
        return True
    flags = (each for each in cmake.named("set") if each.texts and LINKER_FLAGS.search(each.texts[0]))
    return any(FOLDER.search(text) for each in (*cmake.named(*LINKING), *flags) for text in each.texts)


def has_include_folder(headers: Sequence[str], cmake: CMake) -> bool:
    """Return whether CMake adds an include directory for each of some headers, by the name of its library.

    Counted are directories outside of the package and the system, and those that do not exist here.
    """
    folders = [*own_include_folders(cmake)]
    return bool(folders and headers) and all(any(stem(each) in text.lower() for text in folders) for each in headers)


def own_include_folders(cmake: CMake) -> Iterator[str]:
    """Yield the include directories outside of the package and the system, or missing here, as they are written."""
    folders = cmake.package_files.folders
    for call in cmake.named("include_directories", "target_include_directories"):
        for argument in call.command.arguments:
            if OF_VARIABLE.match(argument.text):
                yield argument.text
        for word in call.words:
            path = path_in_package(word.text, call.folder)
            is_outside = word.text.startswith("/") and not word.text.startswith(("/usr/", "/opt/"))
            if is_outside or (path and "/" in path and path not in folders):
                yield word.text
