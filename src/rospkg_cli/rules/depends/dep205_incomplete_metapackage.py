"""DEP205 incomplete-metapackage."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.metapackage_members import MetapackageMembers
from ...checks.enumeration import in_ticks
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule

SEVERAL = 3
"""Further missing members are reported together."""
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
    None of the others needs that package. Of the only metapackage of a repository whose packages share the first word
    of their names, it finds all that it leaves out, also where it is an empty package that names none.

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
    missing, tag = metapackage.missing(), metapackage.tag
    if len(missing) > SEVERAL:
        names = in_ticks(each.name for each in missing)
        message = f"{names} are not named by the metapackage `{facts.name}`: installing it does not install them"
        yield Hit(manifest.path, facts.name_span, f"{message}; add a <{tag}> for each that users need")
        return
    for each in missing:
        line = f"<{tag}>{each.name}</{tag}>"
        message = (
            f"`{each.name}` is not named by the metapackage `{facts.name}`, which is there to bring the packages of "
            f"this repository: installing `{facts.name}` does not install it; add {line}"
        )
        fix = Fix(f"add {line}", (add_dependency(manifest, tag, each.name),), Safety.UNSAFE)
        yield Hit(manifest.path, facts.name_span, message, fix=fix)
