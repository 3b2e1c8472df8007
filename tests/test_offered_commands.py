"""What a message offers ("`rospkg add …` makes it") is done by that command, in every example of the rule."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator

import pytest
from adding import THERE
from cases import CASES

from rospkg_cli.addition.part import put_in
from rospkg_cli.addition.wanted import Wanted, parts_to_add
from rospkg_cli.change.draft import Draft
from rospkg_cli.engine.discovery.discover import packages_in
from rospkg_cli.finding import Finding
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

OFFER = re.compile(r"`rospkg add ([^`]+)`")
OFFERING = [pytest.param(rule, id=rule.code) for rule in all_rules() if rule.code in ("LCH002", "LCH003")]


def offers(rule: Rule) -> Iterator[tuple[Draft, Finding, str]]:
    for example in (*rule.examples, *CASES.get(rule.code, ())):
        files = example.bad_files()
        for finding in lint_files(files, [rule.code], example.targets).findings:
            if found := OFFER.search(finding.message):
                yield Draft(MemoryTree.of(files)), finding, found[1]


def made(draft: Draft, offer: str, path: str) -> Draft:
    """Do what is offered in a package around a path, or in the one that is named."""
    what, name, *option = shlex.split(offer)
    folders = packages_in(draft.tree)
    names = {folder: manifest.name for folder in folders if (manifest := draft.package(folder).parts(Manifest).only)}
    inside = max((each for each in folders if not each or path.startswith(f"{each}/")), key=len)
    folder = next(folder for folder, each in names.items() if each == option[1]) if option else inside
    put_in(draft, folder, parts_to_add(draft.package(folder), Wanted(what, (name,)), name, THERE))
    return draft


@pytest.mark.parametrize("rule", OFFERING)
def test_what_is_offered_repairs_the_finding(rule: Rule) -> None:
    done = set()
    for draft, finding, offer in offers(rule):
        if offer in done:
            continue
        after = made(draft, offer, finding.location.path).tree
        left = lint_files({path: after.entry(path) for path in after.files()}, [rule.code]).findings
        assert finding.message not in {each.message for each in left}, offer
        done.add(offer)
    assert done
