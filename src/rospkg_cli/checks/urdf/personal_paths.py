"""Files that a robot or a world names by a path in one person's home, which other machines do not have."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.xml.parser import Document
from ...lazy_regex import regex
from ...package.urdf.references import text_spans
from ...source import Span
from ..fault import Level
from ..repository.container_folders import is_of_containers

HOME = regex(
    r"\s*(?:file://)?(?:/home/[^/${}<>\s]+/|/root/|/Users/[^/${}<>\s]+/|[A-Za-z]:[\\/]Users[\\/])[^\s${}<>]+\s*"
)
"""The whole of a path; what a substitution fills in is left alone."""

NAMING = frozenset({"filename", "uri", "url", "path"})
WORLDS = (".sdf", ".world")
MODEL = regex(r"/models/(?P<model>[^/]+(?:/.+)?)")
RESOURCES = "which Gazebo looks for in the folders of GZ_SIM_RESOURCE_PATH (the classic one in GAZEBO_MODEL_PATH)"
LIBRARIES = "which Gazebo looks for in the folders of GZ_SIM_SYSTEM_PLUGIN_PATH (the classic one in GAZEBO_PLUGIN_PATH)"
FUEL = regex(r"/fuel/(?P<server>[\w-]+(?:\.[\w-]+)+)/(?P<owner>[^/]+)/models/(?P<model>[^/]+)")
"""Where Gazebo keeps the models that it has fetched."""
INSTALLED = regex(r"/install/(?:[^/]+/)?share/(?P<package>[^/]+)/(?P<path>.+)")

ON_ONE, IN_CONTAINERS = "on one machine", "in containers and homes of this name alone"
Place = tuple[Span, str]
PathMessage = tuple[str, str, Level | None]
"""The message, what to do, and the level."""


def personal_paths(document: Document) -> Iterator[tuple[Span, str]]:
    """Yield the place and the text of each path below a home folder that an attribute or element for files holds."""
    for element in document.root.walk():
        for attribute in element.attributes.values():
            if attribute.name in NAMING and HOME.fullmatch(attribute.value):
                yield attribute.value_span, attribute.value.strip()
        if element.tag in NAMING and not element.children and not element.is_self_closing:
            for span in text_spans(element):
                text = document.source.slice(span)
                if HOME.fullmatch(text):
                    start = span.start + len(text) - len(text.lstrip())
                    yield Span(start, start + len(text.strip())), text.strip()


def included_spans(document: Document) -> frozenset[Span]:
    """Return the places of the names that xacro includes: it opens files, and does not resolve `package://`."""
    includes = (each for each in document.root.walk() if each.tag == "xacro:include")
    return frozenset(each.attributes["filename"].value_span for each in includes if "filename" in each.attributes)


def portable(path: str, *, is_include: bool) -> str:
    """Return how to name a file on any machine: by its package, if the path goes through an install folder."""
    found = INSTALLED.search(path)
    package, rest = (found["package"], found["path"]) if found else ("<package>", "<path>")
    return f"$(find {package})/{rest}" if is_include else f"package://{package}/{rest}"


def for_gazebo(path: str) -> str:
    """Return how a world can name a file: a library, a model that Gazebo fetches, or one that it looks for."""
    if path.endswith(".so"):
        return f"write `{path.rpartition('/')[2]}`, {LIBRARIES}"
    if (kept := FUEL.search(path)) is not None:
        return f"write `https://{kept['server']}/1.0/{kept['owner']}/models/{kept['model']}`, which Gazebo fetches"
    model = MODEL.search(path)
    return f"write `model://{model['model'] if model else '<model>/<path>'}`, {RESOURCES}"


def by_machine(
    found: list[Place], document: Document, files: PackageFiles
) -> Iterator[tuple[list[Place], PathMessage]]:
    """Yield such paths with the message on them; those that containers of the repository have come separately."""
    kept = [each for each in found if is_of_containers(files, each[1])]
    for places, where in (([each for each in found if each not in kept], ON_ONE), (kept, IN_CONTAINERS)):
        if places:
            yield places, (*of_some_machines(places, document, where), "info" if where == IN_CONTAINERS else None)


def of_some_machines(found: list[Place], document: Document, where: str) -> tuple[str, str]:
    """Return the message on such paths and the advice: `$(find …)` for includes of xacro, `package://` for others."""
    more = f" and {len(found) - 1} more" if found[1:] else ""
    verb, them = ("are", "they are") if more else ("is", "it is")
    message = f"`{found[0][1]}`{more} {verb} {where}: elsewhere {them} missing"
    if document.source.path.endswith(WORLDS):
        return message, for_gazebo(found[0][1])
    included, ways = included_spans(document), dict[bool, str]()
    for span, path in found:
        ways.setdefault(span in included, portable(path, is_include=span in included))
    advice = f"write `{next(iter(ways.values()))}`"
    if len(ways) > 1:
        advice = f"write `{ways[True]}` in the include, and `{ways[False]}` elsewhere"
    return message, advice
