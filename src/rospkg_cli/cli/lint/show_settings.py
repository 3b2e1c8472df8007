"""`rospkg lint --show-settings`: which config holds for the run and for each package, and what else decides."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from ...config.file import Config
from ...config.hierarchy import ConfigTree
from ...control_characters import visible
from ...engine.discovery.locate import Located
from ...light_dataclasses import field_names
from ...report.summary import counted
from ...ros.names import FetchedNames
from .lint_options import LintOptions
from .session import known_names, selected_codes, targets

OF_THE_ROOT = ("target", "plugins", "required_version", "fail_on")
"""The keys that count in the root's config alone."""


def show_settings(options: LintOptions, configs: ConfigTree, located: Located, stream: IO[str]) -> int:
    """Print what decides about the run, and each config with its packages; return the exit status."""
    stream.writelines(f"{visible(line)}\n" for line in settings(options, configs, located))
    return 0


def settings(options: LintOptions, configs: ConfigTree, located: Located) -> Iterator[str]:
    scope = located.scope
    count = f"{len(scope.selected)} of {counted(len(scope.folders), 'package')}"
    yield f"packages: {count}, below {located.root}"
    yield f"targets: {', '.join(targets(options.rules.target, configs.root).names) or 'all that are supported'}"
    is_fetched = isinstance(known_names(), FetchedNames)
    yield f"index: {'fetched' if is_fetched else 'none; unknown names are not reported (rospkg index update)'}"
    if scope.incomplete:
        yield f"unknown names are not reported: {scope.incomplete}"
    found: dict[Path | None, tuple[Config, int]] = {configs.root.path: (configs.root, 0)}
    for folder in sorted(scope.selected):
        config = configs.at(located.root / folder)
        found[config.path] = config, found.get(config.path, (config, 0))[1] + 1
    for config, packages in found.values():
        codes = selected_codes(options.rules, config)
        yield ""
        of_root = "the root's, " if config is configs.root else ""
        yield f"{config.path or 'no config'}: {of_root}{counted(packages, 'package')}, {counted(len(codes), 'rule')}"
        yield from keys(config, config is configs.root)


def keys(config: Config, is_root: bool) -> Iterator[str]:
    """Yield the keys that a config sets, as TOML as far as JSON is TOML."""
    usual = Config()
    for name in field_names(Config):
        value = getattr(config, name)
        if name in ("path", "table", "new", "index") or value == getattr(usual, name):
            continue
        unused = "" if is_root or name not in OF_THE_ROOT else "  # does not count: only the root's does"
        if name in ("per_package", "per_path"):
            for each in value:
                table = {"ignore": dict(each.ignore), "severity": dict(each.severity)}
                yield f"  {each.key}.{json.dumps(each.pattern)} = {json.dumps(table, ensure_ascii=False)}"
            continue
        yield f"  {name.replace('_', '-')} = {json.dumps(value, ensure_ascii=False)}{unused}"
