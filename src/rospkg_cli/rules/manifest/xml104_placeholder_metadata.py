"""XML104 placeholder-metadata."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...checks.manifest.placeholders import EMAIL, NAMES, TODO
from ...example import Example, manifest
from ...files import PackageFiles
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...package.manifest import Manifest
from ...rule import rule
from ...source import Span

GOOD = manifest()
LICENSE = regex(r"(?:LICEN[CS]E|COPYING)[^/]*")
LICENSES = tuple(
    f"{name}{suffix}" for name in ("LICENSE", "LICENCE", "COPYING", "License") for suffix in ("", ".md", ".txt", ".rst")
)
"""How the license of a repository is called, which lies above its packages."""
WANTED = "say in one sentence what the package does"


@rule(
    "XML104",
    "placeholder-metadata",
    over=ManifestAndFiles,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "the description is empty: colcon refuses the manifest",
        Severity.INFO: "the description only repeats the name, or the package lies in a folder such as `_legacy`",
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
    repeats the name.

    ## Why is this bad?
    The package index and lawyers read these lines. A release with them is refused in review. An empty description is
    refused by colcon itself.

    ## When it is quiet
    A description that only repeats the name harms no one: it is an info. Text around a `TODO`, addresses that are not
    a template's, and packages of ROS 1, which catkin builds, are left alone. In a folder for what nobody uses any more
    (`_legacy`, `deprecated`, `old`, `backup`) placeholders are infos.
    """
    manifest = package.manifest
    is_left = is_for_ros1(manifest)
    mild = Severity.INFO if package.is_set_aside else None
    for element in manifest.all("description"):
        shown = "".join(piece for each in element.walk() for piece in each.chunks).strip()
        if not shown and not element.children:
            message = "the description is empty: colcon builds the folder as a plain package"
            yield Hit(manifest.path, manifest.span(element), f"{message}; {WANTED}", Severity.ERROR)
        elif not is_left and (TODO.fullmatch(shown) or repeats(manifest.name, shown)):
            is_todo = TODO.fullmatch(shown) is not None
            said = f"the description says `{shown}`" if is_todo else "the description only repeats the package's name"
            yield Hit(manifest.path, manifest.span(element), f"{said}; {WANTED}", mild if is_todo else Severity.INFO)
    for element in manifest.all("license") if not is_left else ():
        if TODO.fullmatch(element.text):
            text = license_text(package.files)
            harm = (
                f"`{text}` says more, and tools read this line" if text else "it does not say who may use the package"
            )
            message = f"the license is `{element.text}`: {harm}; name a license by its SPDX id"
            yield Hit(manifest.path, manifest.span(element), message, mild)
    yield from people(manifest, mild) if not is_left else ()


def is_for_ros1(manifest: Manifest) -> bool:
    """Return whether catkin builds the package, and nothing of ament."""
    tools = {each.name for each in manifest.dependencies if each.tag == "buildtool_depend"}
    return "catkin" in tools and not any(name.startswith("ament_") for name in tools)


def license_text(files: PackageFiles) -> str:
    """Return the file that holds a license: of the package, else of a folder above it; "" where there is none."""
    own = next((path for path in files.paths if LICENSE.fullmatch(path)), "")
    return own or files.above(LICENSES) or ""


def repeats(name: str, text: str) -> bool:
    """Return whether a description is the template's `The my_pkg package`, or the name and nothing else."""
    return re.fullmatch(rf"(the )?{re.escape(name)}( package)?\.?", text, re.IGNORECASE) is not None


def people(manifest: Manifest, mild: Severity | None) -> Iterator[Hit]:
    for element in manifest.all("maintainer", "author"):
        email = element.attributes.get("email")
        if email and EMAIL.fullmatch(email.value):
            message = f"`{email.value}` is a template's address; write the {element.tag}'s own"
            yield Hit(manifest.path, email.value_span, message, mild)
        elif element.text.upper() in NAMES:
            span: Span = manifest.span(element)
            yield Hit(manifest.path, span, f"the {element.tag} is called `{element.text}`; write a name", mild)
