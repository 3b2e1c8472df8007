"""A component that a launch file loads and its package does not register, and the class that is probably intended."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.launch.text import LaunchText
from ...package.package_facts import PackageFacts
from ...ros.well_known import WrongName
from ...suggest import nearest, slips


@dataclass(frozen=True, slots=True)
class UnknownComponent:
    """A component that its package does not register."""

    package: str
    plugin: LaunchText
    name: str
    facts: PackageFacts | None
    """Of the package; None where no package of that name is known at all."""
    elsewhere: tuple[tuple[str, str], ...] = ()
    """Package and class of what other packages register under the same or the same last name."""
    plain: bool = False
    """Whether the text is the name and nothing else."""
    wrong: WrongName | None = None
    """Of a well-known package that is not here: what is wrong with the name."""

    @property
    def suggestion(self) -> str | None:
        """The one class of the package that is near."""
        if self.wrong is not None:
            return self.wrong.better or None
        if self.facts is None:
            return None
        near = nearest(self.name, self.facts.components)
        is_class = near is not None and may_be_intended(tail(self.name), tail(near))
        return near if is_class else same_class(self.name, self.facts)


def is_unregistered(name: str, facts: PackageFacts) -> bool:
    """Return whether a package surely registers no such class: all are known, or it is a slip of one of them."""
    is_open = facts.knows("components") and facts.may_register_more
    return bool(slips(name, facts.components)) if is_open else facts.knows("components")


def tail(name: str) -> str:
    """Return a class without its namespaces."""
    return name.rpartition("::")[2]


def may_be_intended(name: str, near: str) -> bool:
    """Return whether a class may be another one, whatever their namespaces have in common."""
    return name == near or nearest(name, [near]) is not None


def same_class(name: str, facts: PackageFacts) -> str | None:
    """Return the one component whose class has the same name, in whatever namespace."""
    found = [each for each in facts.components if tail(each) == tail(name)]
    return found[0] if len(found) == 1 else None
