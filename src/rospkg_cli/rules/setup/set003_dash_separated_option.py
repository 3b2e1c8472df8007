"""SET003 dash-separated-option."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.setup_cfg_in_use import SetupCfgInUse
from ...example import SETUP_CFG, Example
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

BAD = SETUP_CFG.replace("script_dir", "«script-dir»").replace("install_scripts", "install-scripts")


@rule(
    "SET003",
    "dash-separated-option",
    over=SetupCfgInUse,
    severity=Severity.WARNING,
    examples=(Example(bad={"setup.cfg": BAD}, good={"setup.cfg": SETUP_CFG}, fix=Safety.SAFE),),
)
def dash_separated_option(checked: SetupCfgInUse) -> Iterator[Hit]:
    """
    ## What it does
    Finds options of setup.cfg that are spelt with a hyphen.
    They are `script-dir` and `install-scripts`.

    ## Why is this bad?
    setuptools warns about them since version 54, stopped the build on them in 78.0.1, and took that back only for the
    time being. Underscores work with every version.

    ## When it is quiet
    In sections that setuptools does not read, such as `[tool:pytest]` or `[flake8]`, and in a package of CMake without
    `ament_python_install_package()`, which never runs setuptools. All options of a setup.cfg are one finding.

    ## References
    https://setuptools.pypa.io/en/latest/history.html
    """
    cfg = checked.cfg
    options = [
        option
        for section in cfg.sections.values()
        if section.read_by_setuptools
        for option in section.options.values()
        if "-" in option.key
    ]
    if not options or not checked.is_read:
        return
    first, *others = options
    right = first.key.replace("-", "_")
    message = (
        f"`{first.key}` is spelt with a hyphen: setuptools warns, 78.0.1 refused it, a later one will; write `{right}`"
    )
    edits = tuple(Edit(cfg.path, each.key_span, each.key.replace("-", "_")) for each in options)
    fix = Fix(f"write `{right}`", edits)
    related = tuple(Related(cfg.path, each.key_span, f"and `{each.key}`") for each in others)
    yield Hit(cfg.path, first.key_span, message, related=related, fix=fix)
