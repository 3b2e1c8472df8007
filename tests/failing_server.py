"""`rospkg server` with faults of ours in it, which texts bring out: run by test_server_faults.py."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

from rospkg_cli.cli.server import live_lint, navigation, offered_actions
from rospkg_cli.cli.server.actions import actions
from rospkg_cli.cli.server.run import serve_here
from rospkg_cli.engine.run import worker
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.rule_table import rule_by_code


def failing(real: Any, word: str) -> Any:
    """Return a function that fails where what it is called with has a word in it."""

    def call(*given: Any, **named: Any) -> Any:
        if word in repr(given):
            raise KeyError(word)
        return real(*given, **named)

    return call


def slow_rule(code: str) -> Any:
    """Return a rule; the one about what a description says takes its time or fails where that asks for it."""
    real = rule_by_code(code)

    def check(given: Any) -> Any:
        text = given.manifest.source.text
        if "slowly" in text:
            time.sleep(0.3)
        if "broken rule" in text:
            raise KeyError("of ours")
        return real.check(given)

    return replace(real, check=check) if code == "XML104" else real


def failing_actions(linted: Any, path: Path, asked: Any) -> Any:
    if "actions_that_fail" in str(path):
        raise KeyError("actions")
    return actions(linted, path, asked)


worker.rule_by_code = slow_rule
offered_actions.actions = failing_actions
navigation.definitions = failing(navigation.definitions, "broken_lookup")
live_lint.make_session = failing(live_lint.make_session, "broken_run")
sys.exit(serve_here())
