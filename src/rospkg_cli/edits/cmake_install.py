"""Edits that install more with CMake: an item of a rule of its kind, or a new rule, in the style of the file."""

from __future__ import annotations

from ..finding import Edit
from ..languages.cmake.syntax import CommandInvocation
from ..languages.cmake.targets import Target
from ..package.cmake.cmake_project import CMake
from ..package.cmake.install_rule import InstallRule
from ..source import Span
from .cmake_commands import add_argument, quoted_like
from .cmake_rule_place import add_rule, block, extend_or_add

SHARE = "share/${PROJECT_NAME}"
LIBEXEC = "lib/${PROJECT_NAME}"


def install_folder(cmake: CMake, folder: str) -> Edit:
    """Install a folder into the share directory, with its name."""
    automatic = cmake.named("ament_auto_package", "autoware_ament_auto_package")
    if automatic and (edit := to_share(cmake, automatic[0].command, folder)) is not None:
        return edit
    return extend_or_add(
        cmake,
        lambda rule: (
            rule.kind == "DIRECTORY" and rule.destination == f"share/{cmake.project_name}" and has_no_filter(rule)
        ),
        folder,
        block(cmake.root, "DIRECTORY", folder, SHARE),
    )


def to_share(cmake: CMake, command: CommandInvocation, folder: str) -> Edit | None:
    """Name a folder behind INSTALL_TO_SHARE of ament_auto_package, where CMakeLists.txt itself calls it."""
    if not cmake.root.is_top(command):
        return None
    texts = [argument.text for argument in command.arguments]
    if "INSTALL_TO_SHARE" not in texts:
        behind = command.arguments[-1].span.end if command.arguments else command.inner.start
        indent = cmake.root.indent
        return Edit(
            cmake.root.path, Span(behind, command.inner.end), f"\n{indent}INSTALL_TO_SHARE\n{indent * 2}{folder}\n"
        )
    last = next(
        (i for i, text in enumerate(texts) if i > texts.index("INSTALL_TO_SHARE") and text.isupper()), len(texts)
    )
    before = command.arguments[last - 1].span
    return add_argument(cmake.root, command, quoted_like(cmake.root, folder, before), before)


def install_executable(cmake: CMake, target: Target) -> Edit:
    name = target_reference(cmake, target)
    return extend_or_add(
        cmake,
        lambda rule: rule.kind == "TARGETS" and only_executables(cmake, rule),
        name,
        block(cmake.root, "TARGETS", name, LIBEXEC),
        target.call,
    )


def target_reference(cmake: CMake, target: Target) -> str:
    """Return the name of a target for CMakeLists.txt: as it is written, where that is the same everywhere in it."""
    raw = cmake.source_text(target.word)
    everywhere = target.call.path == cmake.root.path and cmake.root.is_top(target.call.command)
    return raw if everywhere or "$" not in raw.replace("${PROJECT_NAME}", "") else target.name


def install_script(cmake: CMake, path: str) -> Edit:
    return extend_or_add(
        cmake,
        lambda rule: rule.kind == "PROGRAMS" and rule.destination == f"lib/{cmake.project_name}" and not rule.rename,
        path,
        block(cmake.root, "PROGRAMS", path, LIBEXEC),
    )


def install_headers(cmake: CMake) -> Edit:
    """Install include/ to where targets or exports say that it will be, else to `include`, where it is found anyway."""
    texts = [text for call in cmake.named("target_include_directories") for text in call.texts]
    exported = [text for call in cmake.named("ament_export_include_directories") for text in call.texts]
    places = [text for text in texts if "INSTALL_INTERFACE:" in text] + exported
    own = any(f"include/{cmake.project_name}" in text for text in places)
    place = "include/${PROJECT_NAME}" if own else "include"
    return add_rule(cmake, block(cmake.root, "DIRECTORY", "include/", place))


def install_library(cmake: CMake, target: Target, export: str = "") -> Edit:
    """Install a library in the rule of other libraries (of the same export, where one is named), else in a new rule."""

    def fits(rule: InstallRule) -> bool:
        targets = [cmake.target(word.text) for word in rule.items]
        same = rule.export.text == export if rule.export is not None else not export
        return rule.kind == "TARGETS" and same and all(each is not None and each.is_library for each in targets)

    indent = cmake.root.indent
    places = [f"EXPORT {export}"] if export else []
    places += ["ARCHIVE DESTINATION lib", "LIBRARY DESTINATION lib", "RUNTIME DESTINATION bin"]
    lines = "".join(f"\n{indent}{place}" for place in places)
    name = target_reference(cmake, target)
    return extend_or_add(cmake, fits, name, f"install(TARGETS {name}{lines}\n)", target.call)


def has_no_filter(rule: InstallRule) -> bool:
    """Return whether a rule copies whole folders, without a pattern for their files."""
    return not rule.patterns and not rule.permissions and not any(word.text.endswith("/") for word in rule.items)


def only_executables(cmake: CMake, rule: InstallRule) -> bool:
    targets = [cmake.target(word.text) for word in rule.items]
    places = set((rule.destinations or {}).values())
    right = places == {f"lib/{cmake.project_name}"} and rule.export is None
    return right and all(each is not None and each.is_executable for each in targets)
