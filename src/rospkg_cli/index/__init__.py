"""The index of names: fetched from rosdistro, kept in the user's cache, read by whoever asks what a name stands for."""


class NamesError(Exception):
    """An index that can't be fetched, kept or read; the message is one sentence that says what to do."""
