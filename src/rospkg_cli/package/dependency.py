"""One dependency of package.xml."""

from __future__ import annotations

from ..languages.rep149_condition import may_hold
from ..languages.xml.elements import Attribute, Element
from ..light_dataclasses import dataclass
from ..ros.distros import Targets
from ..ros.manifest import VERSION_LIMITS
from ..source import Span


@dataclass(frozen=True)
class Dependency:
    element: Element
    tag: str
    name: str
    span: Span
    """Of the name."""
    condition: str | None = None

    @property
    def limits(self) -> dict[str, Attribute]:
        """The `version_…` attributes, by name."""
        return {name: each for name, each in self.element.attributes.items() if name in VERSION_LIMITS}

    @property
    def key(self) -> tuple[str, tuple[tuple[str, str], ...]]:
        """The name and all attributes: what makes two dependencies of one tag equal."""
        return self.name, tuple(sorted((name, each.value) for name, each in self.element.attributes.items()))

    def active(self, targets: Targets) -> bool:
        """Return whether the condition holds, or may hold, for one of the targets."""
        return may_hold(self.condition, targets.environments())
