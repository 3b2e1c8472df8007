"""Libraries that installed programs and libraries load when they run, by the packages that they are linked with."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.target_links import TargetLink, TargetLinks
from ...ros.libraries import keys_of_linked, stem
from ...source import Span
from .undeclared_includes import IncludeDependencies

VARIABLE = regex(r"\$\{([\w.+-]+?)_(?:TARGETS|LIBRARIES|LIBS)\}")
"""What find_package calls the libraries of a package; the first group is its name."""
HEADERS_ALONE = frozenset({
    "angles", "asio", "catch2", "cli11", "eigen", "eigen_stl_containers", "libcereal-dev", "libcpp-httplib-dev",
    "libcxxopts-dev", "libexpected-dev", "libglm-dev", "libmsgsl-dev", "libnanoflann-dev", "libtclap-dev", "msgpack",
    "libwebsocketpp-dev", "nanoflann", "nlohmann-json-dev", "pybind11-dev", "range-v3", "rapidjson-dev", "tcb_span",
    "tf2_eigen", "tl_expected", "xsimd", "xtensor",
})  # fmt: skip
"""Packages and keys without a library: nothing of them is there at run time."""
NOT_LOADED = ("ament_", "rosidl_", "gtest", "libboost-dev", "boost", "opengl")
"""Prefixes of build tools, and libraries of many parts, most of which are headers."""


@dataclass(frozen=True, slots=True)
class LoadedLibrary:
    names: tuple[str, ...]
    """The packages and keys that serve it, the one to recommend first."""
    target: str
    path: str
    span: Span


def loaded_libraries(includes: IncludeDependencies) -> Iterator[LoadedLibrary]:
    """Yield what installed targets are certainly linked with, without static libraries and header-only ones."""
    links = TargetLinks(includes.cmake)
    for link in links.all:
        target = includes.cmake.target(link.target)
        is_loaded = target is not None and (target.is_executable or links.shared(target)) and target.is_built
        if not is_loaded or link.target not in links.installed or link.call.maybe or link.call.testing:
            continue
        name = package_name(includes, link)
        is_own = not name or includes.cmake.target(name) is not None
        names = () if is_own else includes.find_packages.provided.of(name) or keys_of_linked(name.removeprefix("-l"))
        is_library = names and not names[0].startswith(NOT_LOADED) and not names[0].endswith(("_cmake", "_vendor"))
        if is_library and HEADERS_ALONE.isdisjoint(names):
            yield LoadedLibrary(names, link.target, link.word.path, link.word.span)


def package_name(includes: IncludeDependencies, link: TargetLink) -> str:
    """Return what find_package calls the package of an argument of a link; "" where that is not known."""
    written = includes.cmake.source_text(link.word).strip('"')
    if found := VARIABLE.fullmatch(written):
        name = str(found[1])
        return next((each.name for each in includes.cmake.packages if plain(each.name) == plain(name)), name)
    is_certain = link.word.is_known and not link.word.maybe and "$<" not in link.word.text
    return link.word.text.partition("::")[0] if is_certain else ""


def plain(name: str) -> str:
    """Return a name in a form to compare it with its variables: `yaml-cpp` and `YAML_CPP` are `yaml_cpp`."""
    return name.lower().replace("-", "_")


def is_served_at_run_time(names: tuple[str, ...], run_names: frozenset[str]) -> bool:
    """Return whether a dependency for running is a part of a library: `libmodbus5` of `libmodbus-dev`."""
    return any(stem(name) in other.lower() for name in names for other in run_names)
