"""SET305 license-classifier."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.setup_py import remove_item
from ...example import Example, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...package.setup.setup_py import SetupPy
from ...rule import Profile, rule

TOPIC = "        'Topic :: Software Development',\n"
LICENSE = "        '«License :: OSI Approved :: Apache Software License»',\n"


def classifiers(*lines: str) -> str:
    return setup_py("classifiers=[\n" + "".join(lines) + "    ],")


@rule(
    "SET305",
    "license-classifier",
    over=SetupPy,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={"setup.py": classifiers(LICENSE, TOPIC)},
            good={"setup.py": classifiers(TOPIC)},
            fix=Safety.SAFE,
        ),
    ),
)
def license_classifier(setup: SetupPy) -> Iterator[Hit]:
    """
    ## What it does
    Finds license classifiers.

    ## Why is this bad?
    setuptools warns about them since version 77 (Lyrical has 78), so every build prints a warning. `license=` says the
    same.

    ## When it is quiet
    For classifiers that are made by code that can't be evaluated.

    ## References
    https://peps.python.org/pep-0639/#deprecate-license-classifiers
    """
    for said in setup.texts("classifiers"):
        if said.text.startswith("License ::"):
            edits = remove_item(setup, "classifiers", said)
            fix = Fix("remove the license classifier", edits) if edits else None
            message = (
                f"`{said.text}` is deprecated: setuptools from 77 on warns at each build; remove it, `license=` says it"
            )
            yield Hit(said.path, said.shown, message, fix=fix)
