"""XML105 invalid-email."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.manifest import Manifest
from ...ros.manifest import EMAIL
from ...rule import rule

GOOD = manifest()


@rule(
    "XML105",
    "invalid-email",
    over=Manifest,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"package.xml": GOOD.replace('<maintainer email="ada@example.org">', "«<maintainer>»")},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={"package.xml": GOOD.replace("ada@example.org", "«ada at example.org»")},
            good={"package.xml": GOOD},
        ),
    ),
)
def invalid_email(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds maintainers without an e-mail address, and addresses that release tools refuse.
    Addresses of maintainers and authors are words of letters, digits and `-_%+` joined by dots, an `@`, and a domain
    that ends in letters.

    ## Why is this bad?
    colcon refuses the manifest and builds the folder as a plain package, without its dependencies; `ros2 run` does not
    find it. (`root@localhost` is refused as well.)

    ## When it is quiet
    Authors need no address. Addresses of a template, which can be read, are left to XML104.

    ## References
    - [REP-149, maintainer](https://ros.org/reps/rep-0149.html)
    """
    lost = "colcon builds the folder as a plain package"
    for element in manifest.all("maintainer", "author"):
        email = element.attributes.get("email")
        if email is None and element.tag == "maintainer":
            who = f"the maintainer `{element.text}`" if element.text else "the maintainer"
            message = f'{who} has no e-mail address: {lost}; write `<maintainer email="name@domain.org">`'
            yield Hit(manifest.path, element.open, message)
        elif email is not None and not EMAIL.fullmatch(email.value):
            message = f"`{email.value}` is no e-mail address that release tools can read: {lost}"
            yield Hit(manifest.path, email.value_span if email.value else email.span, message)
