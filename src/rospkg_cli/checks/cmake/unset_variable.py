"""A variable that CMakeLists.txt reads and nothing sets, and whether its command gets the value in another way."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...source import Span
from .package_variables import package_of

NAMING = ("target_include_directories", "target_link_libraries", "target_link_directories", "set")
"""Commands whose first argument says what the others are added to."""
NAMED = 1
ADDING = ("include_directories", "link_libraries", "link_directories", *NAMING)
"""Commands for which one more empty argument makes no difference."""
SAME = {"Boost_INCLUDE_DIRS": "Boost_INCLUDE_DIR"}
"""Variable → another one to which CMake's own module gives the same value."""


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
    def is_shown_by_build(self) -> bool:
        """Whether a folder or a library is lost: the build of a target that needs it fails."""
        target = self.call.command.arguments[:1] if self.call.name in NAMING else []
        is_target = any(word.inner.start <= self.span.start < word.inner.end for word in target)
        return self.call.name in ADDING and self.call.name != "set" and not is_target

    @property
    def is_of_same_package(self) -> bool:
        """Whether the intended variable belongs to the same package."""
        return package_of(self.name) == package_of(self.near)

    @property
    def given_anyway(self) -> str:
        """The intended variable, or one of the same value, where it is another argument of the command; else "".

        A name that is a letter off may be of another package, whose value is lost.
        """
        arguments = self.call.command.arguments if self.is_of_same_package and self.call.name in ADDING else ()
        wanted = {f"${{{name}}}": name for name in (self.near, SAME.get(self.near)) if name}
        texts = [each.text for each in arguments[NAMED if self.call.name in NAMING else 0 :]]
        found = (wanted[text] for text in texts if text in wanted)
        return next(found, "") if f"${{{self.name}}}" in texts else ""
