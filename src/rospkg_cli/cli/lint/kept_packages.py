"""Where the facts and findings of a run's packages are kept, and what all of them depend on."""

from __future__ import annotations

import os
import sys
from zlib import crc32

from ...cache.folder import cache_folder, make_folder
from ...cache.kept_run import run_to_keep
from ...disk import DiskTree
from ...engine.reuse.kept_packages import KeptPackages
from ...engine.run.session import Session
from .lint_options import LintOptions


def kept_packages(options: LintOptions, session: Session) -> KeptPackages | None:
    """Return what is kept of the packages of a session; None where nothing may be used or kept.

    With plugins nothing is: what their rules read of themselves is not known.
    """
    run, folder, tree = run_to_keep(), cache_folder(os.environ), session.tree
    if run is None or options.no_cache or session.settings.plugins or not isinstance(tree, DiskTree):
        return None
    if not make_folder(folder) or not (code := run.code_digest(folder)):
        return None
    scope, answers = session.scope, run.trace.answers
    installed = [question + answer for question, answer in answers.items() if question[0] == "p"]
    named = [question + answer for question, answer in answers.items() if question[0] == "w"]
    facts_key = repr([code, sys.version, installed, str(tree.root), scope.name, session.targets])
    missing = [scope.incomplete, sorted(scope.missing_repositories), scope.cmake_projects]
    around = [missing, sorted(scope.prefix_names), sorted(map(sorted, scope.repositories))]
    rules_key = repr([sorted(session.codes), sorted(session.settings.build_types), around, named])
    name = f"{crc32(os.fsencode(tree.root)):08x}{crc32(repr([session.targets, sorted(session.codes)]).encode()):08x}"
    return KeptPackages(os.path.join(folder, f"packages-{name}"), tree, facts_key, rules_key)  # noqa: PTH118
