"""Names of packages in CMakeLists.txt that are a letter or two off the name of another package (CMK117)."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import replace
from ...suggest import slips
from .mistyped_package import MistypedPackage
from .name_slips import are_swapped, is_likely_slip, nearest
from .package_names import PackageNames


def misspelt_argument(word: Word, call: EvaluatedCommand, names: frozenset[str]) -> MistypedPackage | None:
    """Return the package among some names that an argument is near to; None where there is none."""
    near = nearest(word.text, names, 2)
    if near is None:
        return None
    return MistypedPackage(word, call, "misspelt", near, is_certain=is_likely_slip(word.text, near))


def misspelt_search(word: Word, call: EvaluatedCommand, names: PackageNames) -> MistypedPackage | None:
    """Return what `find_package` should find: nearly what is declared, or a slip of one known package.

    One of the workspace counts where CMake finds it elsewhere, too. What is not declared may be another one.
    """
    if (found := misspelt_argument(word, call, names.unfound)) is not None:
        is_intended = found.near in names.declared or are_swapped(word.text, found.near)
        return replace(found, is_certain=found.is_certain and is_intended)
    near = slips(word.text, names.workspace.names) or slips(word.text, names.workspace.index.packages)
    if len(near) != 1:
        return None
    return MistypedPackage(word, call, "misspelt", near[0], is_certain=are_swapped(word.text, near[0]))
