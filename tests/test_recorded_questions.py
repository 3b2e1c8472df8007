"""What one package asks about the others: each question is noted, and has an answer of its own."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.reuse.answer_digests import METHODS, AnswerDigests
from rospkg_cli.engine.reuse.recorded_facts import Question
from rospkg_cli.engine.reuse.recorded_workspace import RecordedWorkspace
from rospkg_cli.package.package_facts import ActiveDependency, PackageFacts
from rospkg_cli.package.params.declared_parameter import DeclaredParameter
from rospkg_cli.package.plugin import Plugin
from rospkg_cli.package.workspace import Workspace

ARM = PackageFacts("arm", "src/arm", loaders=frozenset({("arm", "arm::Tool")}))
TOOL = Plugin("hand::Grip", "hand::Grip", "arm::Tool", frozenset({"arm"}), "plugins.xml")
HAND = PackageFacts(
    "hand", "src/hand", "ament_cmake", modules=frozenset({"gripping"}), headers=frozenset({"hand"}), plugins=(TOOL,),
    dependencies=(ActiveDependency("depend", "arm"),),
    parameters=(DeclaredParameter("rate", False, "double", False, "src/hand.cpp"),),
)  # fmt: skip
RATE = frozenset({"rate"})
REAL = Workspace((ARM, HAND), frozenset({"src/arm"}))


def asked(ask: str) -> set[Question]:
    seen = RecordedWorkspace(REAL, "src/arm")
    eval(ask, {"w": seen, "RATE": RATE})
    return seen.noted


@pytest.mark.parametrize(
    "ask, noted",
    [
        ("w.at('src/arm').version", set()),
        ("w.at('src/hand')", {("folders",)}),
        ("w.at('src/hand').version", {("folders",), ("field", "src/hand", "version")}),
        ("w.named('arm').version", {("named", "arm")}),
        ("w.named('hand').version", {("named", "hand"), ("field", "src/hand", "version")}),
        ("w.named('leg')", {("named", "leg")}),
        ("w.packages", {("folders",)}),
        ("w.selected", {("selected",)}),
        ("w.names", {("names",)}),
        ("w.package_at('src/hand/x')", {("package_at", "src/hand/x")}),
        ("w.kind_of('hand')", {("is_name", "hand")}),
        ("w.is_available('hand')", {("is_name", "hand")}),
        ("w.is_built_against('arm')", {("is_built_against", "arm")}),
        ("w.loaders_of('arm::Tool')", {("loaders_of", "arm::Tool")}),
        ("w.bases_loaded_from('arm')", {("bases_loaded_from", "arm")}),
        ("w.plugins_of('arm::Tool')", {("plugins_of", "arm::Tool")}),
        ("w.with_header('hand/x.hpp')", {("with_header", "hand/x.hpp")}),
        ("w.providers_of('gripping')", {("providers_of", "gripping")}),
        ("w.having('modules', 'gripping')", {("having", "modules", "gripping")}),
        ("w.having('started_nodes', 'arm', 'x')", {("having", "started_nodes", "arm", "x")}),
        ("w.needing('arm')[0].version", {("needing", "arm"), ("field", "src/hand", "version")}),
        ("w.is_needed('arm')", {("needing", "arm")}),
        ("w.launch.has('x')", {("folders",), ("all", "launch_summaries")}),
        ("w.included_arguments", {("folders",), ("all", "name"), ("all", "launch_files")}),
        ("w.parameters.count_in('src/hand', RATE)", {("folders",), ("all", "parameters")}),
        (
            "[facts.version for facts, _ in w.parameters.counts(RATE)]",
            {("folders",), ("all", "parameters"), ("field", "src/hand", "version")},
        ),
    ],
)
def test_each_question_is_noted(ask: str, noted: set[Question]) -> None:
    assert asked(ask) == noted


@pytest.mark.parametrize(
    "ask",
    [
        "w.named('hand').name", "w.named('leg')", "w.package_at('src/hand/x')", "w.kind_of('hand')",
        "w.is_available('hand')", "w.is_built_against('arm')", "w.loaders_of('arm::Tool')",
        "w.bases_loaded_from('arm')", "w.having('modules', 'gripping')[0].name", "w.needing('arm')[0].folder",
        "w.plugins_of('arm::Tool')", "w.with_header('hand/x.hpp')", "w.providers_of('gripping')",
        "w.parameters.count_in('src/hand', RATE)", "w.parameters.count_in('src/arm', RATE)",
        "[(facts.folder, count) for facts, count in w.parameters.counts(RATE)]",
        "w.selected", "w.names", "w.at('src/hand').plugins", "[each.folder for each in w.packages]",
    ],
)  # fmt: skip
def test_the_answers_are_the_workspace_s(ask: str) -> None:
    recorded, real = (eval(ask, {"w": w, "RATE": RATE}) for w in (RecordedWorkspace(REAL, "src/arm"), REAL))
    assert recorded == real
    assert recorded is not None or "leg" in ask


OTHER = Workspace((PackageFacts("hand", "src/arm", "cmake"), PackageFacts("leg", "src/leg", version="2")))
QUESTIONS: list[Question] = [
    ("folders",), ("all", "build_type"), ("field", "src/arm", "build_type"), ("named", "hand"), ("is_name", "arm"),
    ("selected",), ("names",), ("package_at", "src/hand/x"), ("loaders_of", "arm::Tool"),
    ("is_built_against", "arm"), ("bases_loaded_from", "arm"), ("plugins_of", "arm::Tool"),
    ("with_header", "hand/x.hpp"),
    ("providers_of", "gripping"), ("having", "modules", "gripping"), ("needing", "arm"),
]  # fmt: skip


@pytest.mark.parametrize("question", QUESTIONS)
def test_another_answer_has_another_digest(question: Question) -> None:
    one, again, other = (AnswerDigests(each).digest(question) for each in (REAL, REAL, OTHER))
    assert one == again != ""
    assert "" != other != one


def test_answers_in_plain_values() -> None:
    answer = AnswerDigests(REAL).answer
    assert answer("folders") == ("src/arm", "src/hand")
    assert answer("all", "build_type") == ("", "ament_cmake")
    assert answer("field", "src/hand", "build_type") == "ament_cmake"
    assert (answer("named", "hand"), answer("named", "leg")) == ("src/hand", None)
    assert (answer("is_name", "arm"), answer("is_name", "leg")) == (True, False)
    assert answer("plugins_of", "arm::Tool") == (TOOL,)


def test_there_is_a_question_for_each_method() -> None:
    assert {question[0] for question in QUESTIONS} >= METHODS


@pytest.mark.parametrize("question", [("all", "nothing"), ("field", "src/none", "name"), ("with_header",), ("at", "x")])
def test_what_makes_no_sense_has_no_digest(question: Question) -> None:
    assert AnswerDigests(REAL).digest(question) == ""


@pytest.mark.parametrize("asked, of, is_common", [(9, 17, True), (9, 18, False), (8, 10, False), (10, 19, True)])
def test_what_most_packages_are_asked_for_is_one_question(asked: int, of: int, is_common: bool) -> None:
    packages = tuple(PackageFacts(f"p{number:02}", f"p{number:02}") for number in range(of))
    every: set[Question] = {("field", each.folder, "version") for each in packages[:asked]}
    questions = [each for each, _ in AnswerDigests(Workspace(packages)).of({*every, ("names",)})]
    one: list[Question] = [("all", "version"), ("folders",), ("names",)]
    assert questions == (one if is_common else sorted({*every, ("names",)}))


def test_facts_are_recorded_once_and_computed_once() -> None:
    seen, digests = RecordedWorkspace(REAL, "src/arm"), AnswerDigests(REAL)
    assert seen.at("src/hand") is seen.at("src/hand")
    assert digests.digest(("names",)) is digests.digest(("names",))
    assert digests.known.keys() == {("names",)}


def test_a_package_is_not_built_against_by_itself_nor_to_run() -> None:
    needs = (ActiveDependency("depend", "arm"), ActiveDependency("exec_depend", "hand"))
    assert REAL.is_built_against("arm")
    assert not REAL.is_built_against("hand")
    assert not Workspace((PackageFacts("arm", "src/arm", dependencies=needs),)).is_built_against("arm")
    assert not Workspace((PackageFacts("arm", "src/arm", dependencies=needs),)).is_built_against("hand")
