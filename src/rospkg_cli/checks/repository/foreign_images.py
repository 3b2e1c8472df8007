"""Container images of others that a repository builds on, which may bring unknown modules, packages and programs."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

FROM = regex(r"(?im)^[ \t]*FROM[ \t]+(?:--\S+[ \t]+)*(\S+)(?:[ \t]+AS[ \t]+(\S+))?")
ARG = regex(r"(?m)^[ \t]*(?:(?:ARG|export)[ \t]+)?(\w+)=[\"']?([^\s\"']+)")
VARIABLE = regex(r"\$(?:(\w+)|\{(\w+)(?::?-([^{}]*))?\})")
GIVEN = regex(r"(?m)^[ \t]*(?:-[ \t]+)?[\"']?(?:image|container)[\"']?[ \t]*:[ \t]*[\"']?([\w$][^\s\"'#,]*)")
BUILDS = regex(r"(?m)^[ \t]*[\"']?build[\"']?[ \t]*:")
TAGGED = regex(r"\bdocker(?:x|[ \t]+buildx)?[ \t]+build\b[^\n]*?[ \t](?:-t|--tag)[ \t=]+(\S+)")
FOR_ROS = regex(r"(?i)(?<![a-z])ros2?(?![a-z])|colcon")
"""What a container has in it that runs ROS: not so that of a database or a page."""
OF_REGISTRY = regex(r"^(?:(?:docker|index\.docker|quay|ghcr)\.io/|public\.ecr\.aws/docker/)?(?:library/)?")
PLAIN = regex(
    r"(?:(?:amd64|arm64v8|arm32v7|multiarch)/)?(?:ros|ubuntu|debian|python|alpine|fedora|rockylinux|rust|gcc|node)"
    r"|scratch|buildpack-deps|(?:ros|osrf|rostooling|ros-tooling|ros-planning|moveit|gazebosim|althack|tiryoh)/.*"
    r"|mcr\.microsoft\.com/.*|(?:nvcr\.io/)?nvidia/(?:cuda\w*|l4t-[\w-]+|opengl|vulkan|tensorrt|pytorch|tensorflow)"
)
"""Those of systems and languages, of ROS as it is released, and of drivers for graphics."""


@dataclass(frozen=True, slots=True)
class ForeignImage:
    name: str
    """Without its tag."""
    path: str
    """Of the file that builds on it."""

    @property
    def may_bring(self) -> str:
        """What is said of something that is absent from all that is known."""
        return f"; `{posixpath.basename(self.path)}` builds on `{self.name}`, which may bring it"


def foreign_image(files: PackageFiles) -> ForeignImage | None:
    """Return the first image that containers or workflows of the repository build on, and that is none of the plain
    ones, or made by the repository itself.
    """
    for each, path in files_called(files, OF_CONTAINER, OF_WORKFLOW):
        for name in map(bare, bases(path, each.readable_text(path))):
            if PLAIN.fullmatch(OF_REGISTRY.sub("", name)) is None and not is_made(name, files):
                return ForeignImage(name, path)
    return None


def is_made(image: str, files: PackageFiles) -> bool:
    """Return whether a file of the repository has an image made: by the `build` of a service, or by a command."""
    found = files_called(files, OF_CONTAINER, OF_SCRIPT)
    texts = (each.readable_text(path) for each, path in found if each.holds(path, image.encode()))
    return any(image in map(bare, made(text)) for text in texts)


def bases(path: str, text: str) -> Iterator[str]:
    """Yield the images that a file builds on or runs, as far as their names are known."""
    if path.endswith((".yml", ".yaml", ".json")):
        given = GIVEN.finditer(text)
        found = [each[1] for each in given if FOR_ROS.search(block_around(text, each))]
    else:
        stages = {match[2] for match in FROM.finditer(text) if match[2]}
        found = [each[1] for each in FROM.finditer(text) if each[1] not in stages and FOR_ROS.search(text)]
    yield from filled(found, text)


def made(text: str) -> Iterator[str]:
    """Yield the images that a file has made: those of services with a `build`, and tags of commands."""
    yield from filled(TAGGED.findall(text), text)
    for match in GIVEN.finditer(text):
        if BUILDS.search(block_around(text, match)):
            yield match[1]


def filled(names: list[str], text: str) -> Iterator[str]:
    """Yield names with the values that a file gives their variables; none that begins with an unknown one."""
    values = dict(ARG.findall(text))
    for each in names:
        name = VARIABLE.sub(lambda match: str(values.get(match[1] or match[2], match[3] or "$")), each.strip("\"'"))
        if not name.startswith("$"):
            yield name


def block_around(text: str, found: re.Match[str]) -> str:
    """Return the lines around one in YAML or JSON that are indented at least as it is."""
    lines = text.split("\n")
    at = text.count("\n", 0, found.start())
    depth = indent(lines[at])
    start = next((i for i in range(at, 0, -1) if is_outside(lines[i - 1], depth)), 0)
    end = next((i for i in range(at + 1, len(lines)) if is_outside(lines[i], depth)), len(lines))
    return "\n".join(lines[start:end])


def is_outside(line: str, depth: int) -> bool:
    return bool(line.strip()) and indent(line) < depth


def indent(line: str) -> int:
    return len(line) - len(line.lstrip(" \t"))


def bare(name: str) -> str:
    """Return the name of an image without its tag and digest; a port of a registry stays."""
    whole = name.partition("@")[0]
    before, _, tag = whole.rpartition(":")
    return before if before and "/" not in tag else whole
