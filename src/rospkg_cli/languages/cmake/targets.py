"""The targets that CMake files make, with their sources and options."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Literal

from ...light_dataclasses import dataclass
from .evaluated_command import EvaluatedCommand, flags_and_values
from .values import UNKNOWN, Word

Kind = Literal["executable", "library", "other"]
LIBRARY_TYPES = ("STATIC", "SHARED", "MODULE", "OBJECT", "INTERFACE", "ALIAS", "UNKNOWN")
OF_PYTHON_MODULES = (
    "FREE_THREADED", "LTO", "MUSL_DYNAMIC_LIBCPP", "NB_SHARED", "NB_STATIC", "NB_SUPPRESS_WARNINGS", "NOMINSIZE",
    "NOSTRIP", "NO_EXTRAS", "OPT_SIZE", "PROTECT_STACK", "STABLE_ABI", "THIN_LTO", "WITH_SOABI",
)  # fmt: skip
"""Options of `nanobind_add_module`, `pybind11_add_module` and `python3_add_library`."""
OPTIONS = frozenset({*LIBRARY_TYPES, "IMPORTED", "GLOBAL", "WIN32", "MACOSX_BUNDLE", "EXCLUDE_FROM_ALL",
                     "NO_TARGET_LINK_LIBRARIES", *OF_PYTHON_MODULES})  # fmt: skip


@dataclass(frozen=True)
class Target:
    word: Word
    """The name, with its position."""
    kind: Kind
    call: EvaluatedCommand
    options: frozenset[str] = frozenset()
    """`SHARED`, `INTERFACE`, `EXCLUDE_FROM_ALL` and other options."""
    sources: tuple[Word, ...] = ()
    folder: Word | None = None
    """The folder that ament_auto_add_* takes all sources of."""

    @property
    def name(self) -> str:
        return self.word.text

    @property
    def is_built(self) -> bool:
        """Whether a build makes a file of it that can be installed."""
        return self.kind != "other" and not self.options & {"INTERFACE", "ALIAS", "IMPORTED", "UNKNOWN", "OBJECT"}

    @property
    def is_library(self) -> bool:
        return self.kind == "library"

    @property
    def is_executable(self) -> bool:
        return self.kind == "executable"

    @property
    def artifact(self) -> str:
        """CMake's word for its file on Linux, a library of no given kind being a shared one."""
        return "RUNTIME" if self.is_executable else "ARCHIVE" if "STATIC" in self.options else "LIBRARY"


def target_with_sources(kind: Kind) -> Callable[[EvaluatedCommand], Iterator[Target]]:
    """`add_executable`, `add_library`, their ament_auto forms, and commands that pass arguments on to them."""

    def make(call: EvaluatedCommand) -> Iterator[Target]:
        if call.words:
            options, values, sources = flags_and_values(call.words[1:], OPTIONS, ("DIRECTORY", "NB_DOMAIN"), ())
            folder = next(iter(values.get("DIRECTORY", [])), None)
            sources = [] if "ALIAS" in options else sources
            yield Target(call.words[0], kind, call, frozenset(options), tuple(sources), folder)

    return make


def target_in_its_own_way(kind: Kind) -> Callable[[EvaluatedCommand], Iterator[Target]]:
    """Commands whose first argument is the target that they make."""

    def make(call: EvaluatedCommand) -> Iterator[Target]:
        if call.words:
            yield Target(call.words[0], kind, call)

    return make


def generated_interface(call: EvaluatedCommand) -> Iterator[Target]:
    """generate_parameter_library makes a library without code."""
    if call.words:
        yield Target(call.words[0], "library", call, frozenset({"INTERFACE"}))


def component_executable(call: EvaluatedCommand) -> Iterator[Target]:
    """`rclcpp_components_register_node(… EXECUTABLE name)` makes an executable of a component."""
    _, values, _ = flags_and_values(call.words, (), ("EXECUTABLE", "PLUGIN", "EXECUTOR", "RESOURCE_INDEX"), ())
    for word in values.get("EXECUTABLE", []):
        yield Target(word, "executable", call)


MAKERS: Mapping[str, Callable[[EvaluatedCommand], Iterator[Target]]] = {
    "add_executable": target_with_sources("executable"),
    "ament_auto_add_executable": target_with_sources("executable"),
    "cuda_add_executable": target_with_sources("executable"),
    "add_library": target_with_sources("library"),
    "ament_auto_add_library": target_with_sources("library"),
    "cuda_add_library": target_with_sources("library"),
    "pybind11_add_module": target_with_sources("library"),
    "python3_add_library": target_with_sources("library"),
    "nanobind_add_module": target_with_sources("library"),
    "ament_add_gtest": target_in_its_own_way("executable"),
    "ament_add_gmock": target_in_its_own_way("executable"),
    "ament_add_gtest_executable": target_in_its_own_way("executable"),
    "ament_add_gmock_executable": target_in_its_own_way("executable"),
    "ament_add_google_benchmark": target_in_its_own_way("executable"),
    "ament_auto_add_gtest": target_in_its_own_way("executable"),
    "ament_add_ros_isolated_gtest": target_in_its_own_way("executable"),
    "ament_add_ros_isolated_gmock": target_in_its_own_way("executable"),
    "add_rostest_with_parameters_gtest": target_in_its_own_way("executable"),
    "add_rostest_with_parameters_gmock": target_in_its_own_way("executable"),
    "add_custom_target": target_in_its_own_way("other"),
    "rosidl_generate_interfaces": target_in_its_own_way("other"),
    "generate_parameter_library": generated_interface,
    "generate_parameter_module": generated_interface,
    "rclcpp_components_register_node": component_executable,
}


def targets_of(calls: Iterable[EvaluatedCommand]) -> Iterator[Target]:
    """Yield the targets in the order in which they are made, one whose name is unknown too."""
    for call in calls:
        if maker := MAKERS.get(call.name):
            yield from maker(call)


def targets_by_name(targets: Iterable[Target]) -> dict[str, Target]:
    """Return the targets whose names are known; the first of a name counts."""
    found: dict[str, Target] = {}
    for target in targets:
        if UNKNOWN not in target.name:
            found.setdefault(target.name, target)
    return found
