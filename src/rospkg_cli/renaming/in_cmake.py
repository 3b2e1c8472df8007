"""Where CMake names a package: as project, target, dependency, in variables and paths."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..languages.cmake.parser import parse
from ..languages.cmake.syntax import CommandArgument, CommandInvocation
from ..lazy_regex import regex
from ..source import Source, Span
from .common import OF_CMAKE
from .own_paths import own_paths
from .patterns import ALONE, found
from .renamed_package import RenamedPackage

IN_ARGUMENTS = (
    rf"(?<!\w)%PART%(?=_{OF_CMAKE}(?!\w))",
    r"(?<!\w)%PART%(?=__rosidl_)",
    r"(?<!\w)%PART%(?=__(?:$|[\"\s)]))",
)
TARGETS = (r"(?<![\w:])%PART%(?=::)",)
PROJECT_CLASS = regex(r"(\$\{PROJECT_NAME\})::")
OWN_TARGET = r"(?<=%WORD%::)%PART%(?![\w:-])"
LONGER = r"^%NAME%$"
DEPENDENCIES = frozenset(
    "ament_target_dependencies rosidl_target_interfaces rosidl_get_typesupport_target "
    "ament_index_has_resource ament_index_get_resource ament_index_get_prefix_path target_depends_on_interfaces "
    "ament_export_dependencies rosidl_generate_interfaces ament_auto_find_build_dependencies".split()
)
"""Commands with names of packages among their arguments."""
ALL = frozenset({"ament_export_dependencies", "ament_auto_find_build_dependencies"})
"""Commands that have nothing else among them."""
FIRST = frozenset("find_package find_dependency ament_package_xml pluginlib_export_plugin_description_file".split())
"""Commands whose first argument is the name of a package."""
LISTS = frozenset({"set", "list", "foreach"})
COMPONENTS = ("rclcpp_components_register", "generate_parameter_")
"""Commands whose arguments are classes of C++, or names of headers."""
PLACES = frozenset("install add_subdirectory include_directories file configure_file get_filename_component".split())
TEXTS = frozenset({"message"})


def in_cmake(source: Source, renamed: RenamedPackage, is_own: bool) -> Iterator[Span]:
    """Yield the places in a CMakeLists.txt or a .cmake file; those in comments are left."""
    commands = parse(source).commands
    folder = source.path.rpartition("/")[0]
    lists = package_lists(commands)
    targets = targets_of(commands)
    for command in commands:
        for at, argument in enumerate(command.arguments):
            if argument.text == renamed.old:
                is_name = is_own_name(command, folder, renamed) if is_own else False
                if is_name or names_package(command, at, lists, renamed, targets):
                    yield argument.inner
            elif argument.kind != "paren" and renamed.old in argument.text:
                yield from in_argument(command, argument, renamed, folder if is_own else None)


def in_argument(
    command: CommandInvocation, argument: CommandArgument, renamed: RenamedPackage, folder: str | None
) -> Iterator[Span]:
    templates = list(IN_ARGUMENTS)
    if not command.name.startswith(COMPONENTS):
        templates += TARGETS
    start = argument.inner.start
    targets = (*ALONE, *renamed.libraries) if renamed.has_interfaces else renamed.libraries
    longer = (OWN_TARGET,) if folder is None else (OWN_TARGET, LONGER)
    for span in (*found(templates, argument.text, renamed.old), *found(longer, argument.text, renamed.old, targets)):
        yield Span(start + span.start, start + span.end)
    if command.name.startswith("rclcpp_components_register") and ";" in argument.text:
        return
    if folder is not None:
        for span in own_paths(argument.text, renamed, folder):
            yield Span(start + span.start, start + span.end)
    elif not renamed.others:
        for span in found((r"(?<!\w)include/%NAME%",), argument.text, renamed.old):
            yield Span(start + span.start, start + span.end)


def class_names(source: Source) -> Iterator[Span]:
    """Yield the variable in each `PLUGIN "${PROJECT_NAME}::Class"`: the namespace of the class keeps its name."""
    for command in parse(source).commands:
        if command.name.startswith("rclcpp_components_register"):
            for argument in command.arguments:
                for match in PROJECT_CLASS.finditer(argument.text):
                    start = argument.inner.start
                    yield Span(start + match.start(1), start + match.end(1))


def is_own_name(command: CommandInvocation, folder: str, renamed: RenamedPackage) -> bool:
    """Return whether an argument that is the name alone means the package, or a target of its name."""
    if command.name.startswith("generate_parameter_") or command.name in TEXTS:
        return False
    if command.name not in PLACES:
        return True
    place = f"{folder}/{renamed.old}".lstrip("/")
    return place in renamed.moved or not any(
        path == place or path.startswith(f"{place}/") for path in renamed.package.files.paths
    )


def names_package(
    command: CommandInvocation, at: int, lists: frozenset[str], renamed: RenamedPackage, targets: frozenset[str]
) -> bool:
    """Return whether an argument that is the name alone means the package, in any package's file."""
    if command.name == "catkin_package" or (command.name in FIRST and command.arguments[0].text == "catkin"):
        return True
    if command.name in FIRST:
        return at == 0
    if command.name in DEPENDENCIES:
        return at > 0 or command.name in ALL
    if command.name == "target_link_libraries":
        return at > 0 and renamed.has_library and renamed.old not in targets
    return command.name in LISTS and bool(lists & {each.text for each in command.arguments[:2]})


def package_lists(commands: Sequence[CommandInvocation]) -> frozenset[str]:
    """Return the variables that hold names of packages: commands on packages, or loops, are given them."""
    texts = {
        argument.text for command in commands if command.name in DEPENDENCIES | FIRST for argument in command.arguments
    }
    names = {text[2:-1] for text in texts if text.startswith("${") and text.endswith("}")}
    for command in commands:
        if command.name == "foreach" and command.arguments and command.arguments[0].text in names:
            names |= {each.text.removeprefix("${").removesuffix("}") for each in command.arguments[1:]}
    return frozenset(names)


def targets_of(commands: Sequence[CommandInvocation]) -> frozenset[str]:
    return frozenset(
        each.arguments[0].text for each in commands if each.name in ("add_library", "add_executable") and each.arguments
    )
