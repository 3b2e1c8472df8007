"""Rule input: whether anything of the workspace reads the `<ros2_control>` of a robot; RViz shows one without."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ..fault import Fault
from .enclosing_elements import ancestors
from .opened_robots import XACRO, OpenedRobots
from .xacro_problems import STOPS

READERS = regex(
    r"(?i)controller_manager|ros2_?control|gazebo|ignition|moveit|move_group|webots|mujoco|isaac|"
    r"(?<![a-z])(?:gz|ign)(?![a-z])"
)
"""In the names of programs, packages and launch files that read it, or start what does."""
UNREAD = "; no controller manager and no simulator here reads it"


@dataclass(frozen=True)
class ControlReaders:
    opened: OpenedRobots

    def unless_read(self, root: Element, fault: Fault) -> str:
        """Return what is added to a fault in a `<ros2_control>` that nothing reads; "" for any other."""
        is_inside = STOPS not in fault.message and any(
            each.tag == "ros2_control" for each in ancestors(root, fault.span)
        )
        return UNREAD if is_inside and not self.are_here else ""

    @cached_property
    def are_here(self) -> bool:
        """Whether a text of the package, but robots, names one, or a package of the workspace needs or starts it."""
        own = (text for path, text in self.opened.texts.every if not path.endswith(XACRO))
        names = (name for facts in self.opened.workspace.packages for name in names_of(facts))
        return any(READERS.search(each) for each in (*own, *names))


def names_of(facts: PackageFacts) -> Iterator[str]:
    """Yield what a package is called, needs, starts, and includes in its launch files."""
    yield facts.name
    yield from (each.name for each in facts.dependencies)
    yield from (" ".join(each) for each in facts.started_nodes)
    yield from (name for each in facts.launch_summaries for name in (each.name, *each.includes))
