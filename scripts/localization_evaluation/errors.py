"""What goes wrong for reasons that the user can mend."""


class EvaluationError(Exception):
    """One line that names the thing, its value and what was expected."""
