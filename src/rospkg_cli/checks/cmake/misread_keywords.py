"""Keywords of `rclcpp_components_register_node` in the command for several, which takes them for classes (CMK108)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.components import OF_ONE_NODE

ASKS = "EXECUTABLE"


@dataclass(frozen=True)
class MisreadKeyword:
    """The first one of a command."""

    word: Word
    asks: bool
    """Whether the command asks for a program, which it does not make."""
    program: str
    """The name of that program; "" where it is not known."""
    is_target: bool
    """Whether a target has this name, so that the other command can't make one of that name."""
    is_made: bool
    """Whether something else makes the program: the command then only adds names to an index."""

    def sentence(self, *, is_started: bool) -> str:
        fault = f"`{self.word.text}` is no class: `rclcpp_components_register_nodes` takes classes alone"
        if not self.asks:
            behind = "what stands behind is registered"
            return f"{fault}: {behind}, and `{self.word.text}` as well, which nothing loads; remove it"
        if self.is_made:
            more = "registers the keywords as well, which nothing loads"
            return f"{fault}, and {more}; remove them and `{self.program}`, which is made elsewhere"
        unmissed = ", which nothing here starts" if self.program and not is_started else ""
        other = ", with a name for its executable that no target has" if self.is_target else ""
        return f"{fault}, and makes no executable{unmissed}; write `rclcpp_components_register_node`{other}"


def misread_keywords(package: CMakePackage) -> Iterator[MisreadKeyword]:
    """Yield one for each command that takes classes alone, and is given keywords.

    The classes among its words are registered all the same.
    """
    for call in package.cmake.named("rclcpp_components_register_nodes"):
        keyword = next((word for word in call.words if word.text in OF_ONE_NODE), None)
        if keyword is None:
            continue
        asks = any(word.text == ASKS for word in call.words)
        named = [word for before, word in zip(call.words, call.words[1:], strict=False) if before.text == ASKS]
        program = named[0].text if named and named[0].is_known else ""
        target = package.cmake.target(program)
        is_made = program in package.facts.executables or (target is not None and target.is_executable)
        yield MisreadKeyword(keyword, asks, program, target is not None, is_made)
