"""Variables that no one sets and that are nearly called like one that is set: they are empty."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import assigned_names
from ...languages.cmake.syntax import CommandArgument
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.cmake.set_variables import SetVariables
from ...package.workspace import Workspace
from ...ros.link_targets import MESSAGES, ROS_NAME
from ...ros.names import NameKind
from ...ros.read_table import rows
from ...source import Span
from ...suggest import distance, near_names
from .given_variables import given_variables
from .known_packages import are_all_known
from .mistyped_links import are_swapped, digits

SET_BY_CMAKE = frozenset("""
    PROJECT_NAME PROJECT_SOURCE_DIR PROJECT_BINARY_DIR PROJECT_VERSION CMAKE_PROJECT_NAME CMAKE_SOURCE_DIR
    CMAKE_BINARY_DIR CMAKE_CURRENT_SOURCE_DIR CMAKE_CURRENT_BINARY_DIR CMAKE_CURRENT_LIST_DIR CMAKE_CURRENT_LIST_FILE
    CMAKE_CURRENT_LIST_LINE CMAKE_INSTALL_PREFIX CMAKE_CXX_FLAGS CMAKE_C_FLAGS CMAKE_CXX_COMPILER_ID
    CMAKE_C_COMPILER_ID CMAKE_CXX_COMPILER CMAKE_C_COMPILER CMAKE_CXX_STANDARD CMAKE_C_STANDARD
    CMAKE_INSTALL_BINDIR CMAKE_INSTALL_SBINDIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_LIBEXECDIR CMAKE_INSTALL_SYSCONFDIR
    CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_DATAROOTDIR CMAKE_INSTALL_DATADIR CMAKE_INSTALL_DOCDIR CMAKE_INSTALL_MANDIR
    CMAKE_INSTALL_INFODIR CMAKE_INSTALL_LOCALEDIR
""".split())  # fmt: skip
"""Those that packages use, and all of CMake 3.25 that are near to them."""

REFERENCE = regex(r"(?<!\\)\$\{([A-Za-z_]\w*)\}")
OF_PACKAGE = regex(r"(\w+)_(INCLUDE_DIRS?|INCLUDES|LIBRARY|LIBRARIES|LIBS|TARGETS?|DEFINITIONS)")
CERTAIN = regex(r"rclcpp\w*|tf2\w*|Boost|OpenCV")
"""Packages, besides those of messages, that are known to set their variables under their own name alone."""
SUFFIXES = {"INCLUDE_DIR": "INCLUDE_DIRS", "INCLUDES": "INCLUDE_DIRS", "LIBRARY": "LIBRARIES", "LIBS": "LIBRARIES",
            "TARGET": "TARGETS"}  # fmt: skip
"""What people write, and what ament_package() sets."""
OF_PLAIN_CMAKE = frozenset("apriltag console_bridge fmt octomap orocos_kdl urdfdom_headers".split())
"""Packages of the table without ament: their configs set what they like, as `OCTOMAP_LIBRARIES`."""
OF_TARGETS = ("ament_target_dependencies", "target_link_libraries", "target_include_directories", "add_executable")
"""Commands whose first argument is a target."""
NAMING = ("target_include_directories", "target_link_libraries", "target_link_directories", "set")
"""Commands that add what stands behind their first argument."""
NAMED = 1
ADDING = ("include_directories", "link_libraries", "link_directories", *NAMING)
"""Commands to which an empty argument more is nothing."""
FLAGS = ("CMAKE_CXX_FLAGS", "CMAKE_C_FLAGS")
"""What is mostly empty, but for what a user gives."""
SAME = {"Boost_INCLUDE_DIRS": "Boost_INCLUDE_DIR"}
"""Variable → another one that CMake's own module gives the same value."""
PROJECT = "PROJECT_NAME"
SHORTEST = 6
"""Letters of a name that the package could have intended for one of its own; two may be wrong from twice that on."""

FEW_WORDS = 2
"""Words of a name that many names have."""


@dataclass(frozen=True)
class UnsetVariable:
    name: str
    near: str
    """The variable that is intended; "" where none is near."""
    call: EvaluatedCommand
    span: Span
    before: str
    """The argument as it is written."""
    after: str
    """The argument without the variable."""

    @property
    def is_told_by_build(self) -> bool:
        """Whether a folder or a library is lost, without which the build of a target that needs it does not end."""
        target = self.call.command.arguments[:1] if self.call.name in NAMING else []
        is_target = any(word.inner.start <= self.span.start < word.inner.end for word in target)
        return self.call.name in ADDING and self.call.name != "set" and not is_target

    @property
    def beside(self) -> str:
        """The intended variable, or one of the same value, where the command adds it all the same; else "".

        A name that is a letter off may be of another thing, which is lost.
        """
        is_meant = package_of(self.name) == package_of(self.near) and self.call.name in ADDING
        arguments = self.call.command.arguments if is_meant else ()
        wanted = {f"${{{name}}}": name for name in (self.near, SAME.get(self.near)) if name}
        texts = [each.text for each in arguments[NAMED if self.call.name in NAMING else 0 :]]
        found = (wanted[text] for text in texts if text in wanted)
        return next(found, "") if f"${{{self.name}}}" in texts else ""


@dataclass(frozen=True)
class UnsetVariables:
    package: CMakePackage
    workspace: Workspace

    @property
    def cmake(self) -> CMake:
        return self.package.cmake

    def all(self) -> Iterator[UnsetVariable]:
        """Yield each place once; slips of PROJECT_NAME alone where a file that can't be read may set any variable."""
        if self.cmake.reads_unknown_files:
            yield from self.of_the_project()
            return
        seen: set[tuple[str, int]] = set()
        for call in self.cmake.calls:
            place = (call.path, call.command.span.start)
            if place not in seen and call.name != "message":
                seen.add(place)
                for argument in call.command.arguments:
                    yield from self.within(call, argument)
        yield from self.of_loops()
        yield from self.of_targets()

    def brings(self, each: UnsetVariable) -> bool:
        """Return whether targets get the package of a variable in another way: by its name, or the right variable."""
        found = OF_PACKAGE.fullmatch(each.near)
        if found is None or package_of(each.name) != package_of(each.near) or each.call.name not in ADDING:
            return False
        if found[2].startswith("INCLUDE"):
            return True  # where the folder is needed, the build has told so
        given = {text for call in self.cmake.named("ament_target_dependencies") for text in call.texts[1:]}
        linked = (text for call in self.cmake.named("target_link_libraries") for text in call.texts[1:])
        is_linked = found[1] in given or any(text.startswith(f"{found[1]}::") for text in linked)
        adding = (call for call in self.cmake.named(*ADDING) if call is not each.call)
        arguments = (argument.text for call in adding for argument in call.command.arguments[1:])
        return is_linked or any(f"${{{each.near}}}" in text for text in arguments)

    def is_certain(self, each: UnsetVariable) -> bool:
        """Return whether a variable is certainly empty and certainly a slip: it is one letter off the intended one, and
        nothing that nobody knows may set it. One of CMake is set by no package under nearly its name."""
        if self.cmake.reads_unknown_files or (each.near and not is_one_letter_off(each.name, each.near)):
            return False
        is_own = not each.near or each.near in self.assigned
        return each.near in SET_BY_CMAKE or (is_own and (self.are_known or are_swapped(each.name, each.near)))

    @cached_property
    def are_known(self) -> bool:
        return are_all_known(self.cmake, self.workspace)

    def is_harmless(self, each: UnsetVariable) -> bool:
        """Return whether flags are to be kept, and the package has set none before."""
        sets = (call for call in self.cmake.named("set") if call.texts[:1] == (each.near,))
        is_kept = each.call.name == "set" and each.near in FLAGS
        return is_kept and next(sets, each.call).command is each.call.command

    def of_the_project(self) -> Iterator[UnsetVariable]:
        """Yield slips of PROJECT_NAME in what is installed; no file of the package has the name elsewhere."""
        for call in (each for each in self.cmake.calls if each.name == "install"):
            for argument in call.command.arguments:
                yield from self.within(call, argument)

    def of_loops(self) -> Iterator[UnsetVariable]:
        """Yield what a loop is to run over, where it certainly does so: an empty one does nothing, without a word."""
        root = self.cmake.root
        for command in (each.command for each in root.body if isinstance(each, Block)):
            for argument in command.arguments[1:] if command.name == "foreach" else ():
                yield from self.within(EvaluatedCommand(command, (), root.path, ""), argument)

    def within(self, call: EvaluatedCommand, argument: CommandArgument) -> Iterator[UnsetVariable]:
        if argument.kind == "bracket" or "${" not in argument.text:
            return
        for found in REFERENCE.finditer(argument.text):
            if near := self.intended(found[1], call):
                start = argument.inner.start
                span = Span(start + found.start(), start + found.end())
                after = argument.text.replace(found[0], "")
                yield UnsetVariable(found[1], near, call, span, argument.text, after)

    def of_targets(self) -> Iterator[UnsetVariable]:
        """Yield what `install(TARGETS)` is given and nothing sets, though it is like no other variable."""
        for rule in self.cmake.installs:
            for word in rule.items if rule.kind == "TARGETS" and not rule.call.maybe else ():
                name = self.variables.empty_variable(word)
                if name is not None and not self.nearest(name):
                    yield UnsetVariable(name, "", rule.call, word.span, f"${{{name}}}", "")
        for call, word in self.needed():
            name = self.variables.empty_variable(word) if not call.maybe else None
            if name is not None and not self.nearest(name):
                yield UnsetVariable(name, "", call, word.span, f"${{{name}}}", "")

    def needed(self) -> Iterator[tuple[EvaluatedCommand, Word]]:
        """Yield the arguments without which CMake stops: the target of a command, the files of interfaces."""
        for call in self.cmake.named(*OF_TARGETS):
            yield from ((call, word) for word in call.words[:1])
        for call in self.cmake.named("rosidl_generate_interfaces"):
            files = tuple(takewhile(lambda word: not word.text.isupper(), call.words[1:]))
            if all(self.variables.empty_variable(word) for word in files):
                yield from ((call, word) for word in files)

    def intended(self, name: str, call: EvaluatedCommand) -> str | None:
        """Return the variable that a command means, as far as that is certain of it."""
        if self.cmake.reads_unknown_files:
            is_slip = name not in self.variables.mentioned and bool(near_names(name, [PROJECT]))
            return PROJECT if is_slip else None
        found = self.of_cmake(name) if call.maybe else self.nearest(name)
        return found or (self.with_lost_word(name) if call.name == "install" and not call.maybe else None)

    def nearest(self, name: str) -> str | None:
        """Return the variable that is intended by one that nothing sets."""
        if name in SET_BY_CMAKE or self.variables.may_be_set(name):
            return None
        is_given = name in self.given
        return self.of_cmake(name) or (None if is_given else self.of_package(name) or self.near_own(name))

    def of_cmake(self, name: str) -> str | None:
        """Return the variable of CMake that is intended."""
        if name in SET_BY_CMAKE or self.variables.may_be_set(name):
            return None
        alike = (each for each in SET_BY_CMAKE if digits(each) == digits(name))
        return next(iter(near_names(name, alike)), None)

    def of_package(self, name: str) -> str | None:
        """Return what a package that is found sets, where only the case, the ending or a letter of its name differs."""
        found = OF_PACKAGE.fullmatch(name)
        package = self.packages.get(found[1].lower()) or self.near_package(found[1]) if found else None
        if found is None or package is None:
            return None
        suffix = SUFFIXES.get(found[2], found[2]) if package.islower() else found[2]
        wanted = f"{package}_{suffix}"
        return wanted if wanted != name and not self.variables.may_be_set(name) else None

    def near_package(self, name: str) -> str | None:
        """Return the one package that is found and a letter off a name that is none itself."""
        is_clear = len(name) >= SHORTEST and ROS_NAME.fullmatch(name) is not None
        is_package = self.workspace.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
        if not is_clear or is_package or self.workspace.named(name):
            return None
        near = near_names(name, (each for each in self.packages.values() if digits(each) == digits(name)), 1)
        return near[0] if len(near) == 1 else None

    @cached_property
    def packages(self) -> dict[str, str]:
        """Name in small letters → name of the packages whose variables are known."""
        names = [each.name for each in self.cmake.packages]
        certain = (each for each in names if CERTAIN.fullmatch(each) or is_of_ros(each) or self.is_made_here(each))
        return {name.lower(): name for name in certain}

    def is_made_here(self, name: str) -> bool:
        """Return whether ament_package() writes the variables of a package of the workspace."""
        facts = self.workspace.named(name)
        return facts is not None and facts.build_type == "ament_cmake"

    def near_own(self, name: str) -> str | None:
        """Return a variable that the package itself sets, where no other one can be intended.

        It may be the same in small letters or capitals, which CMake tells apart.
        """
        if len(name) < SHORTEST or not self.variables.is_own(name):
            return None
        same = [each for each in self.assigned if each.lower() == name.lower()]
        if len(same) == 1:
            return same[0]
        alike = (each for each in self.assigned if digits(each) == digits(name))
        return next(iter(near_names(name, alike, 1 if len(name) < 2 * SHORTEST else 2)), None)

    def with_lost_word(self, name: str) -> str | None:
        """Return the one variable that the package sets and that is called as an unset one, but for one word."""
        if self.variables.may_be_set(name) or not self.variables.is_own(name):
            return None
        words = name.strip("_").split("_")
        others = [(each, each.strip("_").split("_")) for each in self.assigned]
        alike = [each for each, whole in others if lacks_one(words, whole) or lacks_one(whole, words)]
        return alike[0] if len(alike) == 1 and len(words) > FEW_WORDS else None

    @cached_property
    def given(self) -> frozenset[str]:
        """What the user may give: it is empty on purpose where it is not given."""
        return frozenset(given_variables(self.cmake.calls, self.cmake.files))

    @cached_property
    def assigned(self) -> frozenset[str]:
        return frozenset(name for file in self.cmake.files for name in assigned_names(file))

    @cached_property
    def variables(self) -> SetVariables:
        return SetVariables(self.cmake)


def is_one_letter_off(name: str, near: str) -> bool:
    return distance(name, near, 1) <= 1 and name.lower() != near.lower()


def package_of(variable: str) -> str:
    """Return the package whose variable it is, or else the whole name, in capitals."""
    found = OF_PACKAGE.fullmatch(variable.upper())
    return found[1] if found is not None else variable.upper()


def lacks_one(words: list[str], whole: list[str]) -> bool:
    """Return whether some words are all others but one."""
    return len(whole) == len(words) + 1 and any(whole[:n] + whole[n + 1 :] == words for n in range(len(whole)))


def is_of_ros(name: str) -> bool:
    """Return whether ament_package() writes what a package sets: its variables begin with its own name."""
    is_in_table = name in rows("cmake_targets.txt") and ROS_NAME.fullmatch(name) is not None
    is_other = name.endswith("_vendor") or name in OF_PLAIN_CMAKE
    return MESSAGES.fullmatch(name) is not None or (is_in_table and not is_other)
