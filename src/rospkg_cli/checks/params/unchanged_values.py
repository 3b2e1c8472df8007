"""Values whose loss changes nothing, as they are the default of their parameter, or probably are."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

from ...languages.yaml.nodes import ScalarNode, SequenceNode, YamlNode
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import NodeBlock
from ...package.workspace import Workspace
from ...ros.known_nodes import default_of, is_same_value, known_parameters

SIM_TIME = "use_sim_time"
"""A parameter of every node, which is false by default."""
TYPICAL = frozenset({"false", "0", "0.0", "", "[]"})
"""What most parameters are that have such a type."""
DEFAULT = ": it is the default of `{}`"
PROBABLE = " where it is the default of `{}`, as such a value mostly is"
ONLY_DEFAULTS = ", and nothing differs: the values are the defaults, or mostly are"

Defaults = Callable[[str], tuple[str, ...]]
"""From the name of a parameter to the defaults that its declarations have, each "" where it is unknown."""


def value_text(value: YamlNode) -> str | None:
    """Return a scalar of YAML, `[]` for an empty list; None for all else, and where nothing is written."""
    if isinstance(value, ScalarNode):
        return value.text if value.text or not value.is_plain else None
    return "[]" if isinstance(value, SequenceNode) and not value.items else None


def same_as_default(text: str | None, intended: str, defaults: Iterable[str]) -> str:
    """Return why dropping a value that is for a parameter changes nothing; "" where something may differ.

    A known default decides; where it is unknown, false, 0, an empty text and an empty list are taken for it.
    """
    found = tuple(defaults)
    if text is None or not intended or not all(map(partial(is_unchanged, text), found or ("",))):
        return ""
    return f", and nothing differs{DEFAULT if found and all(found) else PROBABLE}".format(intended)


def is_unchanged(text: str, default: str) -> bool:
    """Return whether a value is a default, which is "" where it is not known."""
    return is_same_value(text, default) if default else text.strip().lower() in TYPICAL


def holds_defaults(block: NodeBlock, defaults: Defaults) -> bool:
    """Return whether a block gives only defaults of its node, so that nothing is lost where it is not read."""
    given = [(each.name, value_text(each.value)) for each in block.parameters]
    return bool(given) and all(same_as_default(text, name, defaults(name)) for name, text in given)


def defaults_in(packages: Iterable[str | None], workspace: Workspace) -> Defaults:
    """Return a function that gives the defaults of a parameter in some packages, of the workspace or well-known."""
    owners = tuple(packages)

    def of(name: str) -> tuple[str, ...]:
        if name == SIM_TIME:
            return ("false",)
        return tuple(each for package in owners if package for each in defaults_of(package, name, workspace))

    return of


def defaults_of(package: str, name: str, workspace: Workspace) -> tuple[str, ...]:
    facts = workspace.named(package)
    return declared_defaults([facts], name) if facts is not None else known_defaults([package], name)


def known_defaults(packages: Iterable[str], name: str) -> tuple[str, ...]:
    """Return the defaults of a parameter in those of some well-known packages that declare it, or may."""
    return tuple(
        default_of(each, name)
        for each in packages
        if not known_parameters(each) or any(one.fits(name) for one in known_parameters(each))
    )


def declared_defaults(packages: Iterable[PackageFacts], name: str) -> tuple[str, ...]:
    """Return the defaults of what declares a parameter; one without any, which must be given, differs from all."""
    fitting = [each for facts in packages for each in facts.parameters if each.fits(name)]
    return tuple(NEEDED if each.required else each.default for each in fitting)


NEEDED = "\0"
"""In the place of a default: the node stops where no value is given."""
