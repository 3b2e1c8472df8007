"""Names that differ from those of the same parameter file for another robot, where the code declares that one's."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.params.parameter_file import NodeBlock, Parameter, ParameterFile
from .declaring_packages import ParameterContext, is_its_own
from .rcl_types import given_type


def unlike_variants(given: ParameterContext) -> Iterator[tuple[ParameterFile, Parameter, str, str]]:
    """Yield a parameter that nothing declares, the declared one that another file has in its place, and that file.

    Both files have one name, and their blocks are alike but for the two: `config/boat/filter.yaml` and
    `config/car/filter.yaml`.
    """
    declared = given.package.parameters
    everywhere = [each for facts in given.workspace.packages for each in facts.parameters]
    for file, other in pairs(given.files):
        for block in file.blocks:
            for likewise in (each for each in other.blocks if each.name == block.name):
                (more, less) = difference(block, likewise), difference(likewise, block)
                if len(more) == len(less) == 1 and given_type(more[0].value) == given_type(less[0].value) != "":
                    name, intended = more[0].name, less[0].name
                    is_declared = any(each.fits(intended) and not each.tail for each in declared)
                    if is_declared and is_its_own(name) and not any(each.fits(name) for each in everywhere):
                        yield file, more[0], intended, other.path


def pairs(files: tuple[ParameterFile, ...]) -> Iterator[tuple[ParameterFile, ParameterFile]]:
    """Yield the pairs of files with the same name in other folders."""
    named: dict[str, list[ParameterFile]] = {}
    for file in files:
        named.setdefault(file.path.rpartition("/")[2], []).append(file)
    for several in named.values():
        yield from ((one, other) for one in several for other in several if one is not other)


def difference(block: NodeBlock, other: NodeBlock) -> list[Parameter]:
    """Return the parameters of a block that another one lacks."""
    names = {each.name for each in other.parameters}
    return [each for each in block.parameters if each.name not in names]
