"""DEP205 incomplete-metapackage."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.metapackage_members import MetapackageMembers
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule

PARTS = ("arm", "base", "camera", "driver", "msgs")
FILES = {f"acme_{part}/package.xml": manifest("", "ament_cmake", f"acme_{part}") for part in PARTS} | {
    f"acme_{part}/CMakeLists.txt": CMAKE.replace("my_pkg", f"acme_{part}") for part in (*PARTS, "robot")
}


def metapackage(*parts: str) -> str:
    body = "".join(f"  <exec_depend>acme_{part}</exec_depend>\n" for part in parts)
    return manifest(body, "ament_cmake", "acme_robot")


@rule(
    "DEP205",
    "incomplete-metapackage",
    over=MetapackageMembers,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            on="",
            bad={
                ".github/workflows/build.yml": "on: push\n",
                "LICENSE": "Apache License\n",
                **FILES,
                "acme_robot/package.xml": metapackage(*PARTS[:-1]).replace(
                    "<name>acme_robot</name>", "<name>«acme_robot»</name>"
                ),
            },
            good={"acme_robot/package.xml": metapackage(*PARTS)},
            fix=Safety.UNSAFE,
        ),
    ),
)
def incomplete_metapackage(metapackage: MetapackageMembers) -> Iterator[Hit]:
    """
    ## What it does
    Finds metapackages that name nearly all packages of their repository and leave one out.
    None of the others needs that package. Tests, examples, demos and other metapackages are left alone, and so are
    packages that need the metapackage.

    ## Why is this bad?
    Users who install the metapackage to have everything lack a package; mostly it was forgotten when that package was
    added.

    ## When it is quiet
    Packages that another named package needs come with it. Tests, examples, demos and other metapackages are left out
    on purpose, and so are packages that need the metapackage. More than a few that are missing are a choice.

    ## Fix safety
    The package may be left out on purpose.
    """
    manifest, facts = metapackage.declared.manifest, metapackage.declared.facts
    for each in metapackage.missing():
        line = f"<{metapackage.tag}>{each.name}</{metapackage.tag}>"
        message = (
            f"`{each.name}` is not named by the metapackage `{facts.name}`, and nearly all other packages of the "
            f"repository are: installing `{facts.name}` does not install it; add {line}"
        )
        fix = Fix(f"add {line}", (add_dependency(manifest, metapackage.tag, each.name),), Safety.UNSAFE)
        yield Hit(manifest.path, facts.name_span, message, fix=fix)
