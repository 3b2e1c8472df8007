"""SET003 dash-separated-option."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import SETUP_CFG, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.setup.setup_cfg import SetupCfg
from ...rule import rule

BAD = SETUP_CFG.replace("script_dir", "«script-dir»").replace("install_scripts", "«install-scripts»")


@rule(
    "SET003",
    "dash-separated-option",
    over=SetupCfg,
    severity=Severity.WARNING,
    examples=(Example(bad={"setup.cfg": BAD}, good={"setup.cfg": SETUP_CFG}, fix=Safety.SAFE),),
)
def dash_separated_option(cfg: SetupCfg) -> Iterator[Hit]:
    """
    ## What it does
    Finds options of setup.cfg that are spelt with a hyphen.
    They are `script-dir` and `install-scripts`.

    ## Why is this bad?
    setuptools warns about them since version 54, stopped the build on them in 78.0.1, and took that back only for the
    time being. Underscores work with every version.

    ## References
    https://setuptools.pypa.io/en/latest/history.html
    """
    for section in cfg.sections.values():
        if not section.read_by_setuptools:
            continue
        for option in section.options.values():
            if "-" in option.key:
                right = option.key.replace("-", "_")
                message = (
                    f"`{option.key}` is spelt with a hyphen: setuptools warns about it, 78.0.1 refused it and a later "
                    f"one will; write `{right}`"
                )
                fix = Fix(f"write `{right}`", (Edit(cfg.path, option.key_span, right),))
                yield Hit(cfg.path, option.key_span, message, fix=fix)
