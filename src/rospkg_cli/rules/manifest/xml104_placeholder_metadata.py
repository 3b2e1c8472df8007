"""XML104 placeholder-metadata."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...model.manifest import Manifest
from ...rule import rule

GOOD = manifest()
NOTHING = "describe what the package does in one sentence"
BOILERPLATE = re.compile(r"TODO\b.*|(The )?[\w-]+ package|(Package )?description", re.IGNORECASE | re.DOTALL)


@rule(
    "XML104",
    "placeholder-metadata",
    over=Manifest,
    severity=Severity.WARNING,
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
    ),
)
def placeholder_metadata(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds what a template left in package.xml: a `TODO` description or license, an e-mail address at `todo.todo`, a
    description that is empty or only repeats the name.

    ## Why is this bad?
    `ros2 pkg list`, the package index and lawyers read these lines. A release with them is refused in review.
    """
    for element in manifest.all("description"):
        if not element.children and (not element.text or BOILERPLATE.fullmatch(element.text)):
            shown = element.text or "nothing"
            yield Hit(manifest.path, manifest.span(element), f"the description says `{shown}`; {NOTHING}")
    for element in manifest.all("license"):
        if element.text.upper().startswith("TODO"):
            message = f"the license is `{element.text}`: nobody may use this package; name one by its SPDX id"
            yield Hit(manifest.path, manifest.span(element), message)
    for element in manifest.all("maintainer", "author"):
        email = element.attributes.get("email")
        if email and email.value.lower().endswith(("@todo.todo", "@todo.com")):
            message = f"`{email.value}` is a template's address; write the {element.tag}'s own"
            yield Hit(manifest.path, email.value_span, message)
