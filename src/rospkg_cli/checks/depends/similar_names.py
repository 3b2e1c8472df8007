"""The one package or key that an unknown name certainly stands for, by letters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import dataclass
from ...package.missing_repositories import COMMON
from ...package.workspace import Workspace
from ...ros.name_suggestions import letters, names_by_typos
from ...ros.rosdep import NOT_THERE
from ...suggest import NAME_STEPS, Effort

MIN_LETTERS = 5
"""Of a misspelt name, behind `lib`: a shorter one is similar to too many others."""

MIN_FAMILY = 3
"""So many packages of the workspace begin with a word before it counts as the prefix of a family."""


class IntendedNames(dict[str, str | None]):
    """The intended names for unknown ones: several packages may declare one, and several rules ask."""


@dataclass(frozen=True)
class SimilarNames:
    workspace: Workspace

    def with_family_prefix(self, name: str) -> str | None:
        """Return the only package of the workspace that has the name after a family prefix: `acme_arm` for `arm`."""
        matching = [each for each in self.workspace.names if each.endswith(f"_{name}")]
        if len(matching) != 1 or self.workspace.is_listed(name):
            return None
        prefix = matching[0].removesuffix(name)
        family = [each for each in self.workspace.names if each.startswith(prefix)]
        return matching[0] if "_" not in prefix[:-1] and len(family) >= MIN_FAMILY else None

    def renamed(self, name: str) -> str | None:
        """Return the only package of the workspace with the same last words that no other one declares, else None."""
        if self.workspace.is_listed(name):
            return None
        words = name.split("_")
        for count in range(len(words) - 1, 0, -1):
            ending = "_" + "_".join(words[-count:])
            alike = [each for each in self.workspace.names - {name} if each.endswith(ending)]
            if alike:
                is_rare = len(alike) == 1 and len(ending) > MIN_LETTERS and ending[1:] not in COMMON
                return alike[0] if is_rare and not self.workspace.is_needed(alike[0]) else None
        return None

    def intended(self, name: str) -> str | None:
        """Return the only name that differs in case, hyphens and underscores alone, or by one typo; else None."""
        known = self.workspace.index_of(IntendedNames)
        if name not in known:
            may_be_slip = len(name.removeprefix("lib")) >= MIN_LETTERS and not self.workspace.is_listed(name)
            groups = self.groups(name) if may_be_slip else iter(())
            alike = next(filter(None, groups), [])
            known[name] = alike[0] if len(alike) == 1 else None
            if Effort.left < 0:
                return known.pop(name)
        return known[name]

    def groups(self, name: str) -> Iterator[list[str]]:
        """Yield names that are alike, the most certain first, those of the workspace before all others; none when
        effort is used up."""
        everything = (sorted(self.workspace.names - {name}), [each for each in self.installable() if each != name])
        Effort.left -= NAME_STEPS * sum(map(len, everything))
        bare, first = letters(name), name[0].lower()
        for names in everything if Effort.left >= 0 else ():
            yield [each for each in names if each[0].lower() == first and letters(each) == bare]
        for names in everything if Effort.left >= 0 else ():
            alike = [each for each in names if each[0].lower() == first]  # a slip in the first letter is rare
            yield from names_by_typos(name, alike, 1)[:1]

    def installable(self) -> Iterable[str]:
        """Return the released packages, and the keys that rosdep has a rule for."""
        index = self.workspace.index
        return (*index.packages, *(key for key, ways in index.keys.items() if set(ways) != {NOT_THERE}))
