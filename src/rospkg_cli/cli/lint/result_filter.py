"""What sets findings aside after a run: the config, then a baseline; and how a baseline is written."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from ...config.hierarchy import ConfigTree
from ...current_folder import absolute
from ...engine.config_filter import ConfigFilter
from ...engine.discovery.locate import Located
from ...engine.run.results import Results
from ...engine.run.session import Session
from ...report import Report
from ..streams import say


def result_filter(
    baseline: Path | None, configs: ConfigTree, located: Located
) -> Callable[[Session, Results], Results]:
    """Return the filter of a session's results; raises BaselineError."""
    by_config = ConfigFilter(configs, located.root, located.scope, located.exclusions)
    if baseline is None:
        return by_config
    from ...engine.baseline import apply_baseline, read_baseline

    known, shown = read_baseline(baseline), relative_to(baseline, located.root)
    return lambda session, results: apply_baseline(by_config(session, results), known, shown)


def relative_to(baseline: Path, root: Path) -> Callable[[str], str]:
    """Return what makes a path below the root relative to the baseline's folder."""
    folder = absolute(baseline).parent
    return lambda path: Path(os.path.relpath(root / path, folder)).as_posix()


def save_baseline(path: Path, report: Report) -> int:
    """Write the findings of a report as a baseline; return the exit status."""
    from ...engine.baseline import write_baseline
    from ...engine.fixing.write import write_text

    findings = report.results.findings
    write_text(path, write_baseline(findings, relative_to(path, report.root)))
    say(f"baseline `{path}` written with {len(findings)} findings; use it with: rospkg lint --baseline {path}")
    return 0
