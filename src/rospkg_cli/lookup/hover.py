"""What is to be known of what a file names, as Markdown."""

from __future__ import annotations

from collections.abc import Iterator

from ..package.manifest import Manifest
from ..package.package_facts import PackageFacts
from ..package.params.declared_parameter import DeclaredParameter
from ..ros.distros import DISTROS
from ..ros.names import NameKind, Names
from .declared_default import default_behind
from .definition import declaration_site, definitions
from .mention import Mention
from .world import LookupWorld

MAX_LINES = 40
"""Of an interface that is shown."""


def hover(world: LookupWorld, folder: str, mention: Mention) -> str:
    """Return what is known of a mention; "" where nothing is."""
    teller = {
        "package": of_package,
        "rule": of_rule,
        "parameter": of_parameter,
        "interface": of_interface,
        "executable": of_installed,
        "component": of_installed,
        "file": of_installed,
        "function": of_installed,
    }[mention.kind]
    return "\n\n".join(teller(world, folder, mention))


def of_package(world: LookupWorld, _: str, mention: Mention) -> Iterator[str]:
    facts, names = world.workspace.named(mention.name), world.workspace.index
    if facts is not None:
        yield f"**{facts.name}** {facts.version}, in this workspace: `{facts.folder or '.'}`"
        for manifest in world.package(facts.folder).parts(Manifest).good:
            if described := manifest.first("description"):
                yield " ".join(described.text.split())
        return
    kind = names.kind_of(mention.name)
    if kind is NameKind.PACKAGE:
        yield f"**{mention.name}**, a ROS package of {', '.join(having(names, mention.name))}"
        yield f"`apt install ros-$ROS_DISTRO-{mention.name.replace('_', '-')}`"
    elif kind is NameKind.KEY:
        yield from of_key(names, mention.name)
    else:
        known = "an unknown name" if kind is NameKind.UNKNOWN else "not known here; `rospkg index update` fetches names"
        yield f"**{mention.name}**: {known}"


def having(names: Names, name: str) -> list[str]:
    return [each.name for each in DISTROS if each.name in names.packages.get(name, ())]


def of_key(names: Names, key: str) -> Iterator[str]:
    """Yield what installs a key on the Ubuntu of each distribution."""
    ways = {each.ubuntu: names.installer(key, each) for each in DISTROS}
    yield f"**{key}**, a rosdep key: {', '.join(f'{way} on {ubuntu}' for ubuntu, way in ways.items() if way != '-')}"
    packages = [package for package, keys in names.apt.items() if key in keys]
    if "apt" in ways.values():
        yield f"`apt install {packages[0] if packages else key}`"


def of_rule(_: LookupWorld, __: str, mention: Mention) -> Iterator[str]:
    from ..rule_docs import explain
    from ..rule_table import rule_by_code, rule_entries

    if mention.name in rule_entries():
        yield explain(rule_by_code(mention.name))


def of_parameter(world: LookupWorld, folder: str, mention: Mention) -> Iterator[str]:
    for facts in sorted(world.workspace.packages, key=lambda each: each.folder != folder):
        for each in facts.parameters:
            if each.fits(mention.name):
                said = [each.type or "type unknown", *(["required"] if each.required else [])]
                said += [f"default `{default}`" for default in [default_of(world, facts, each)] if default]
                yield f"**{mention.name}**: {', '.join(said)}; declared in `{facts.name}`, `{each.path}`"


def default_of(world: LookupWorld, facts: PackageFacts, declared: DeclaredParameter) -> str:
    place = declaration_site(world, facts, declared)
    return default_behind(world.source(place.path).text, place.span.start, place.span.end) if place else ""


def of_interface(world: LookupWorld, folder: str, mention: Mention) -> Iterator[str]:
    facts = world.facts(mention.package, folder)
    name = f"{facts.name if facts else mention.package}/{mention.name}"
    yield f"**{name}**"
    for place in definitions(world, folder, mention):
        lines = world.source(place.path).text.rstrip().split("\n")
        shown = "\n".join([*lines[:MAX_LINES], *(["…"] if len(lines) > MAX_LINES else [])])
        yield f"```\n{shown}\n```"


def of_installed(world: LookupWorld, folder: str, mention: Mention) -> Iterator[str]:
    """Yield what it is and where it is installed from."""
    facts = world.facts(mention.package, folder)
    if facts is None:
        yield f"{mention.kind} of **{mention.package}**, which is not in this workspace"
        return
    places = [place.path for place in definitions(world, folder, mention)]
    start = f"**{mention.name}**, {mention.kind} of `{facts.name}`"
    yield f"{start}: {', '.join(f'`{path}`' for path in places)}" if places else f"{start}; nothing here installs it"
