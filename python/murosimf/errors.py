"""What goes wrong, in one line: where, what, and what to do. The texts are those of the program `murosimf`."""


class Error(Exception):
    """Of all others."""


class InputError(Error, ValueError):
    """An error in a file, an option or a value: "scenes/a.toml:3:7: unknown level 'full'; did you mean 'full_dynamics'?"."""


class UnknownName(InputError, KeyError):  # noqa: N818
    """There is no robot, object, sensor ... of that name; says which is the nearest."""

    def __str__(self) -> str:
        return Exception.__str__(self)  # KeyError puts quotes around it


class ArgumentError(InputError, TypeError):
    """An argument of another kind than the function takes: "Scene.step: steps takes a whole number, not 1.5"."""


class StateError(Error, RuntimeError):
    """A call that cannot be made now: in another thread, in a controller, after a fork."""


class SimulationError(Error, RuntimeError):
    """The run cannot go on: control software has failed. What it raised is the cause, with its traceback."""


SetupError = InputError
