"""XML104 placeholder-metadata."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.left_lines import WANTED, LeftLine, descriptions, joined, people, shown_text
from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...checks.manifest.placeholders import TODO
from ...example import Example, manifest
from ...files import PackageFiles
from ...finding import Hit, Related, Severity
from ...lazy_regex import regex
from ...package.manifest import Manifest
from ...rule import rule

GOOD = manifest()
LICENSE = regex(r"(?:LICEN[CS]E|COPYING)[^/]*")
LICENSES = tuple(
    f"{name}{suffix}" for name in ("LICENSE", "LICENCE", "COPYING", "License") for suffix in ("", ".md", ".txt", ".rst")
)
"""How the license of a repository is called, which lies above its packages."""
MAX_NAMED = 5
"""How many further lines a message names."""


@rule(
    "XML104",
    "placeholder-metadata",
    over=ManifestAndFiles,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "the description is empty: colcon refuses the manifest",
        Severity.INFO: "it is no license but a description, a name or an address, or the package lies in a folder such "
        "as `_legacy`",
    },
    examples=(
        Example(
            bad={"package.xml": GOOD.replace("Drives my robot", "«TODO: Package description»")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("Apache-2.0", "«TODO: License declaration»")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("ada@example.org", "«ada@todo.todo»")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("Drives my robot", "«The my_pkg package»")},
            good={"package.xml": GOOD},
        ),
    ),
)
def placeholder_metadata(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds placeholders that a template left in package.xml.
    They are a `TODO` description or license, an e-mail address at `todo.todo`, a description that is empty or only
    repeats the name. Several in one file are one finding, at the first of the most severe ones.

    ## Why is this bad?
    The package index and lawyers read these lines. Who finds no license may not use the package. An empty description
    is refused by colcon itself.

    ## When it is quiet
    Descriptions, names and addresses of a template harm no build and no release: without a license that is left they
    are an info, and so is a license next to another one that is named. Text around a `TODO`, addresses that are not a
    template's, and packages of ROS 1, which catkin builds, are left alone. In a folder for unused code
    (`_legacy`, `deprecated`, `old`, `backup`) placeholders are infos. A line with an ignore comment of its own is
    reported separately, unless the finding is at that line.
    """
    manifest = package.manifest
    for element in manifest.all("description"):
        if not shown_text(element) and not element.children:
            message = "the description is empty: colcon builds the folder as a plain package"
            yield Hit(manifest.path, manifest.span(element), f"{message}; {WANTED}", Severity.ERROR)
    lines = [] if is_for_ros1(manifest) else [*descriptions(manifest), *licenses(package), *people(manifest)]
    for first, *others in joined(manifest.source, lines):
        level = Severity.WARNING if first.is_grave and not package.is_set_aside else Severity.INFO
        related = tuple(Related(manifest.path, each.span, "this too") for each in others[:MAX_NAMED])
        yield Hit(manifest.path, first.span, first.message + also(others), level, related)


def also(others: list[LeftLine]) -> str:
    """Return what a message says of further lines of a template."""
    if not others:
        return ""
    named = [each.name for each in others[:MAX_NAMED]]
    rest = [f"{len(others) - MAX_NAMED} more"] if len(others) > MAX_NAMED else []
    *names, last = named + rest
    return f"; {', '.join(names)} and {last} are a template's too" if names else f"; {last} is a template's too"


UNKNOWN_LICENSE, WANTED_LICENSE = "it does not say who may use the package", "name a license by its SPDX id"


def licenses(package: ManifestAndFiles) -> Iterator[LeftLine]:
    manifest = package.manifest
    has_one = any(each.text and not TODO.fullmatch(each.text) for each in manifest.all("license"))
    for element in manifest.all("license"):
        if TODO.fullmatch(element.text):
            text = license_text(package.files)
            harm = f"`{text}` says more, and tools read this line" if text else UNKNOWN_LICENSE
            harm, todo = ("another line names one", "remove this one") if has_one else (harm, WANTED_LICENSE)
            message = f"the license is `{element.text}`: {harm}; {todo}"
            yield LeftLine(manifest.span(element), message, f"the license `{element.text}`", is_grave=not has_one)


def is_for_ros1(manifest: Manifest) -> bool:
    """Return whether catkin builds the package, and nothing of ament."""
    tools = {each.name for each in manifest.dependencies if each.tag == "buildtool_depend"}
    return "catkin" in tools and not any(name.startswith("ament_") for name in tools)


def license_text(files: PackageFiles) -> str:
    """Return the file that holds a license: of the package, else of a folder above it; "" where there is none."""
    own = next((path for path in files.paths if LICENSE.fullmatch(path)), "")
    return own or files.above(LICENSES) or ""
