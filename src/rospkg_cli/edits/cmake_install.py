"""Edits that install more with CMake: an item in a rule of its kind, or a new rule, in the layout of the file."""

from __future__ import annotations

from collections.abc import Callable

from ..finding import Edit
from ..languages.cmake.evaluated_command import EvaluatedCommand
from ..languages.cmake.file import CMakeFile
from ..languages.cmake.syntax import CommandInvocation
from ..languages.cmake.targets import Target
from ..package.cmake.cmake_project import CMake
from ..package.cmake.install_rule import InstallRule
from ..source import Span
from .cmake_commands import add_after, add_argument, add_at_end, add_block_before, quoted_like

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
    """Return what CMakeLists.txt calls a target: as it is written, where that means the same everywhere in it."""
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
    """Install include/ to where targets or exports say that it will be, else to where it is found without a word."""
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


def extend_or_add(
    cmake: CMake, fits: Callable[[InstallRule], bool], item: str, lines: str, made: EvaluatedCommand | None = None
) -> Edit:
    """Put an item into the last rule that fits, in CMakeLists.txt or where the item is made, else add a rule.

    `made` is the call that makes the item, where it is a target: CMake wants it first.
    """
    if made is not None and made.maybe:
        inside = "\n".join(f"{cmake.root.indent}{line}" for line in lines.split("\n"))
        return add_rule(cmake, f"if(TARGET {item})\n{inside}\nendif()", made)
    for rule in reversed(cmake.installs):
        command = rule.call.command
        near = rule.call.path in (cmake.root.path, made.path if made else "")
        file = cmake.file(rule.call.path)
        if near and file.is_top(command) and runs_after(cmake, command, made) and not rule.call.maybe and fits(rule):
            last = rule.items[-1:]
            written = [argument for argument, words in rule.call.by_argument() if last and words[-1:] == last]
            if written:
                return add_argument(file, command, quoted_like(file, item, written[0].span), written[0].span)
    return add_rule(cmake, lines, made)


def runs_after(cmake: CMake, command: CommandInvocation, made: EvaluatedCommand | None) -> bool:
    """Return whether a command runs after a call."""
    if made is None:
        return True
    return cmake.last_index(command) > cmake.last_index(made.command)


def add_rule(cmake: CMake, lines: str, made: EvaluatedCommand | None = None) -> Edit:
    """Put a rule below the last one, else before the tests and ament_package()."""
    root = cmake.root
    last = root.last_install
    if last is not None and runs_after(cmake, last, made):
        return add_after(root, last, f"\n{lines}")
    end = root.end
    if end is None and (nested := in_block_of_package(root, lines)) is not None:
        return nested
    return add_at_end(root, lines) if end is None else add_block_before(root, end, lines)


def in_block_of_package(root: CMakeFile, lines: str) -> Edit | None:
    """Put a rule into the block that holds ament_package(): below its last rule, else before that command."""
    ends = [each for each in root.syntax.commands if each.name == "ament_package"]
    if len(ends) != 1:
        return None
    indent = indent_of(root, ends[0])
    shifted = "\n".join(f"{indent}{line}" if line else line for line in lines.split("\n"))
    inside: list[CommandInvocation] = []
    for each in root.syntax.commands[: root.syntax.commands.index(ends[0])]:
        if len(indent_of(root, each)) < len(indent):
            inside.clear()
        elif each.name == "install" and indent_of(root, each) == indent:
            inside.append(each)
    return add_after(root, inside[-1], f"\n{shifted}") if inside else add_block_before(root, ends[0], shifted)


def indent_of(root: CMakeFile, command: CommandInvocation) -> str:
    """Return the blanks before a command, or all that is before it in its line."""
    line = root.source.line_span(root.source.position(command.span.start)[0])
    return root.source.text[line.start : command.span.start]


def block(file: CMakeFile, kind: str, item: str, destination: str) -> str:
    indent = file.indent
    return f"install({kind} {item}\n{indent}DESTINATION {destination}\n)"


def has_no_filter(rule: InstallRule) -> bool:
    """Return whether a rule for folders copies whole folders, and nothing is said of which files."""
    return not rule.patterns and not rule.permissions and not any(word.text.endswith("/") for word in rule.items)


def only_executables(cmake: CMake, rule: InstallRule) -> bool:
    targets = [cmake.target(word.text) for word in rule.items]
    places = set((rule.destinations or {}).values())
    right = places == {f"lib/{cmake.project_name}"} and rule.export is None
    return right and all(each is not None and each.is_executable for each in targets)
