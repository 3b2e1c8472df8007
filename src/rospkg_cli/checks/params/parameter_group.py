"""Parameters of one block with the packages that declare them, and names among them that are probably misspelt."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.declared_parameter import DeclaredParameter, type_named
from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from ...suggest import near_names, same_words
from .unchanged_values import declared_defaults, same_as_default, value_text

BLOCK_WORD = 4
"""Letters of a word that is like the block's name: `segment` in `segmentation`."""


@dataclass(frozen=True)
class ParameterGroup:
    """Parameters of a block that belong together: those without a prefix, or all of one prefix, and their owners."""

    file: ParameterFile
    block: NodeBlock
    prefix: str
    parameters: tuple[Parameter, ...]
    owners: tuple[PackageFacts, ...]
    """The packages that declare most of them; none where that is unknown."""

    def fitting(self, name: str) -> list[DeclaredParameter]:
        return [each for each in self._by_last.get(name.rpartition(".")[2], ()) if each.fits(name)]

    @cached_property
    def _by_last(self) -> dict[str, list[DeclaredParameter]]:
        """What the owners declare, by the last piece of its name, which is that of all names that it fits."""
        found: dict[str, list[DeclaredParameter]] = {}
        for each in (each for facts in self.owners for each in facts.parameters):
            found.setdefault(each.name.rpartition(".")[2], []).append(each)
        return found

    def unknown(self) -> Iterator[tuple[Parameter, str]]:
        """Yield the parameters that no owner declares, where one that is declared and not set has a similar name."""
        given = {each.name for each in self.block.parameters}
        for parameter in self.parameters:
            if not self.fitting(parameter.name):
                before, _, last = parameter.name.rpartition(".")
                prefix = f"{before}." if before else ""
                free = {name for name in self.last_names if prefix + name not in given and self.fitting(prefix + name)}
                found = near_names(last, free) or same_words(last, free) or but_for_its_block(last, before, free)
                if len(found) == 1:
                    yield parameter, prefix + found[0]

    @cached_property
    def last_names(self) -> frozenset[str]:
        """The last pieces of the names that the owners declare."""
        return frozenset(self._by_last)

    def type_of(self, name: str) -> str:
        """Return the type that every owner declares a name with; "" where they differ."""
        return type_named(self.fitting(name), name)

    def same_as_default(self, parameter: Parameter, name: str) -> str:
        """Return why the lost value of a misspelt parameter changes nothing; "" where something may differ."""
        defaults = declared_defaults(self.owners, name)
        return same_as_default(value_text(parameter.value), name.rpartition(".")[2], defaults)

    def wanted_type(self, parameter: Parameter) -> tuple[str, DeclaredParameter] | None:
        """Return the type that every owner declares a parameter with, and one declaration; None where they differ."""
        fitting = self.fitting(parameter.name)
        wanted = type_named(fitting, parameter.name)
        return (wanted, fitting[0]) if wanted else None


def but_for_its_block(name: str, before: str, names: Collection[str]) -> list[str]:
    """Return the names that a name is without words of its block: of `segmentation.min_points_segment`."""
    around = [word for word in before.replace(".", "_").split("_") if len(word) >= BLOCK_WORD]
    words = name.split("_")
    own = [each for each in words if not any(alike(each, word) for word in around)]
    return [each for each in names if own and len(own) < len(words) and each.split("_") == own]


def alike(word: str, other: str) -> bool:
    return len(word) >= BLOCK_WORD and (word.startswith(other) or other.startswith(word))
