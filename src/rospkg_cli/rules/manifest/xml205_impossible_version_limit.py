"""XML205 impossible-version-limit."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.version_limits import VersionLimits
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...languages.version_range import is_empty
from ...package.dependency import Dependency
from ...ros.manifest import VERSION_LIMIT
from ...rule import rule

GOOD = manifest('  <exec_depend version_gte="1.2" version_lt="2.0.0">tf2_ros</exec_depend>\n')


@rule(
    "XML205",
    "impossible-version-limit",
    over=VersionLimits,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "an invalid limit that tests of package.xml refuse",
        Severity.INFO: "an invalid limit where no test does that, more limits than a range has, or limits that no "
        "version can meet where nothing shows that the package is released",
    },
    examples=(
        Example(
            bad={"package.xml": GOOD.replace('"1.2"', '"«1.2-beta»"')},
            good={"package.xml": GOOD},
        ),
        Example(
            bad={
                "package.xml": GOOD.replace('<exec_depend version_gte="1.2"', '«<exec_depend version_gte="3"').replace(
                    '2.0.0">', '2.0.0">»'
                ),
                "tracks.yaml": "tracks: {}\n",
            },
            good={"package.xml": GOOD},
        ),
        Example(
            bad={
                "package.xml": GOOD.replace(
                    '<exec_depend version_gte="1.2" version_lt="2.0.0">',
                    '«<exec_depend version_eq="1.2" version_gte="1.0">»',
                )
            },
            good={"package.xml": GOOD},
        ),
    ),
)
def impossible_version_limit(package: VersionLimits) -> Iterator[Hit]:
    """
    ## What it does
    Finds version limits that are invalid, contradictory or redundant.
    Valid are versions such as `1`, `1.2` and `1.2.3`. Limits are contradictory if no version can meet them, and
    redundant if there are three or more, or others in addition to `version_eq`.

    ## Why is this bad?
    colcon ignores them. The schema refuses the first kind, and a Debian package made by bloom can't be installed where
    no version fits.

    ## When it is quiet
    Limits that some version can meet are left alone, however narrow. Only packages that bloom makes are held to their
    limits: where no file of bloom, no job for it and no CHANGELOG.rst shows a release, limits that contradict each
    other are an info. So are those that say more than a range.

    ## References
    - [REP-149, build_depend](https://ros.org/reps/rep-0149.html): "Two of these attributes can be used together to
      describe a version range."
    """
    tests, manifest = package.tests, package.tests.manifest
    for each in manifest.dependencies:
        wrong = [limit for limit in each.limits.values() if not VERSION_LIMIT.fullmatch(limit.value.strip())]
        for limit in wrong:
            message = f"`{limit.name}` is `{limit.value}`, not one to three numbers such as `1.2`: {tests.harm}"
            level = Severity.WARNING if tests.is_tested else Severity.INFO
            yield Hit(manifest.path, limit.value_span if limit.value else limit.span, message, level)
        if wrong or len(each.limits) < 2:
            continue
        shown = " ".join(f'{name}="{limit.value}"' for name, limit in each.limits.items())
        if is_empty({name: limit.value.strip() for name, limit in each.limits.items()}):
            message = f"no version of `{each.name}` can meet {shown}: a package made by bloom can't be installed"
            held, why = (None, "") if package.release.is_made else (Severity.INFO, "; nothing here makes one")
            yield Hit(manifest.path, each.element.open, message + why, held)
        elif surplus(each):
            message = f"{shown} says more than a range: {surplus(each)}"
            yield Hit(manifest.path, each.element.open, message, Severity.INFO)


def surplus(dependency: Dependency) -> str:
    if "version_eq" in dependency.limits:
        return "`version_eq` allows only one version; remove the others"
    return "one lower and one upper limit are enough; remove the others" if len(dependency.limits) > 2 else ""
