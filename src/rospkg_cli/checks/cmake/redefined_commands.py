"""Functions and macros of a package that are called like a command of CMake or ament, which they replace."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.command_blocks import Block, commands_in
from ...languages.cmake.commands import COMMANDS
from ...languages.cmake.file import CMakeFile
from ...languages.cmake.targets import MAKERS
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...ros.read_table import words
from ...source import Span

EVERYWHERE = frozenset(
    "find_package find_library find_path get_filename_component include include_directories install list message set "
    "set_property set_target_properties string target_link_libraries".split()
)
"""What the files of nearly all packages call that CMake finds."""


@dataclass(frozen=True)
class RedefinedCommand:
    name: str
    path: str
    span: Span
    calls_itself: bool
    """Whether its body calls the command, which is then itself, without end."""
    is_called: bool
    """Whether the package calls it, or files do that any package finds."""
    may_be_intended: bool = False
    """Whether only a text is lost, or only the package's own calls run it, for which it does something."""
    lost: str = ""
    """Why the definition may not hold: the end of a sentence."""


SAYS = "message"
IDLE = frozenset({SAYS, "return", "set"})
"""What does nothing of what another command is called for."""

AMENT = "ament_"

OF_QT = regex(r"qt\d?_\w+")
"""Commands that Qt has with and without its version: who writes for several defines one by the other."""


OF_OTHERS = regex(
    r"(?:pybind11|nanobind|qt[456]|qt_add|rosidl|rclcpp|pluginlib|generate_parameter)_\w+"
    r"|add_(?:launch|ros|rostest)_\w+|find_ros1_\w+|\w*_rmw_\w+"
)
"""Commands that are known here, and that neither CMake nor ament defines."""
MODULES = frozenset(
    "cmakefinddependencymacro cmakepackageconfighelpers cmakeprinthelpers externalproject featuresummary fetchcontent "
    "findcuda finddoxygen findfltk findgtest findpkgconfig findprotobuf findpython findpython2 findpython3 "
    "findpythonlibs findqt findqt3 findqt4 googletest".split()
)
"""Files of CMake that define commands of other names; a package may bring a copy of one."""


@dataclass(frozen=True)
class RedefinedCommands:
    cmake: CMake

    def all(self) -> Iterator[RedefinedCommand]:
        """Yield what stands outside of any `if`, and does not call the former command by its name `_command`.

        A file that is called like the command, or like a module of CMake, is the one that defines it, or a copy.
        """
        for file in self.cmake.files:
            for block in file.body:
                if isinstance(block, Block) and block.command.name in ("function", "macro"):
                    yield from self.judged(file, block)

    def judged(self, file: CMakeFile, block: Block) -> Iterator[RedefinedCommand]:
        for argument in block.command.arguments[:1]:
            name = argument.text.lower()
            called = {each.name for each in commands_in([block])}
            is_wrapper = bool(OF_QT.fullmatch(name)) and any(OF_QT.fullmatch(each) for each in called)
            is_copy = is_definer(file.path, name)
            if name in self.known and f"_{name}" not in called and not is_wrapper and not is_copy:
                lost, is_called = self.why_lost(file, block, name), self.is_called(name, block)
                is_intended = name == SAYS or (name not in EVERYWHERE and not called <= IDLE)
                yield RedefinedCommand(name, file.path, argument.span, name in called, is_called, is_intended, lost)

    def why_lost(self, file: CMakeFile, block: Block, name: str) -> str:
        """Return why a definition may not hold: ament's own comes behind it, or its file is read under a condition."""
        later = (each for each in self.cmake.packages if each.call.path == file.path)
        behind = (each for each in later if each.call.command.span.start > block.command.span.start)
        if name.startswith(AMENT) and any(each.name.startswith(AMENT) for each in behind):
            return "; ament's own, which CMake finds behind it, takes its place again"
        stem = file.path.rpartition("/")[2].removesuffix(".cmake")
        reads = [c for c in self.cmake.named("include") if c.texts and stem in c.texts[0].rpartition("/")[2]]
        return "; its file is read under a condition alone" if reads and all(c.maybe for c in reads) else ""

    def is_called(self, name: str, block: Block) -> bool:
        """Return whether a command is run besides in its own definition, which calls nothing by itself."""
        own = {id(each) for each in commands_in([block])}
        return name in EVERYWHERE or any(id(call.command) not in own for call in self.cmake.named(name))

    @cached_property
    def known(self) -> frozenset[str]:
        names = {*words("cmake_commands.txt"), *COMMANDS, *MAKERS}
        return frozenset(name for name in names if not OF_OTHERS.fullmatch(name))


def is_definer(path: str, command: str) -> bool:
    """Return whether a file is called like that in which CMake or ament defines a command."""
    stem = path.rpartition("/")[2].lower().removesuffix(".cmake").replace("_", "")
    return path.endswith(".cmake") and (stem == command.replace("_", "") or stem in MODULES)
