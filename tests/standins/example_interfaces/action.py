from dataclasses import dataclass, field


class Fibonacci:
    @dataclass
    class Goal:
        order: int = 0

    @dataclass
    class Result:
        sequence: list = field(default_factory=list)

    @dataclass
    class Feedback:
        sequence: list = field(default_factory=list)

    class Impl:
        @dataclass
        class FeedbackMessage:
            feedback: object = None
