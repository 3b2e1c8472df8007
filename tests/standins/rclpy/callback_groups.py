class ReentrantCallbackGroup:
    """Lets callbacks run at once."""
