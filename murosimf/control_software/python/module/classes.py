"""Classes in Python that act in a simulation: what the module murosimf-python.so does in Python itself.

The module compiles this text when the first class is loaded, and calls `load`, the methods of `Loaded`, and `explain`.
Mistakes of the user are `Refusal`: one line that says where.
"""

import difflib
import importlib
import importlib.util
import inspect
import io
import os
import sys
import threading
import traceback

HERE = __file__
OWN_INTERPRETER = False  # else that of a Python program, which handles Ctrl-C itself
USUAL_READS = ("joint_position", "joint_velocity")
USUAL_WRITES = ("joint_target",)
PHASES = ("sense", "control", "contact", "interaction", "observe")


class Refusal(Exception):
    """One line for the user."""


class Late(BaseException):
    """Raised in a call that takes too long."""

    __module__ = "murosimf"


class Interrupted(BaseException):
    """Raised in a call while the program is asked to end."""


class RunEnd(BaseException):
    """Raised by `end` of what a class of a scene file sees."""

    __module__ = "murosimf"


try:
    import numpy as np
except ImportError as error:
    raise Refusal(
        f"controller 'python' needs NumPy, which Python {sys.version.split()[0]} ({sys.prefix}) cannot import: {error}"
    ) from None


def nearest(name, known):
    close = difflib.get_close_matches(name, known, 1)
    return f"; did you mean '{close[0]}'?" if close else ""


class Row(np.ndarray):
    """An array that takes labels, too: joint_target["j_l_shin"] = 0.4."""

    def __array_finalize__(self, other):
        self._numbers = self._name = None

    def _number(self, label):
        if self._numbers is None:
            raise KeyError(f"'{label}': only the robot's own array knows its numbers by name, not what is made of it")
        if label not in self._numbers:
            raise KeyError(f"there is no '{label}' in it{nearest(label, self._numbers)}")
        return self._numbers[label]

    def __getitem__(self, key):
        return super().__getitem__(self._number(key) if type(key) is str else key)

    def __setitem__(self, key, value):
        try:
            super().__setitem__(self._number(key) if type(key) is str else key, value)
        except ValueError:
            if self._name is None or self.flags.writeable:
                raise
            raise ValueError(f"'{self._name}' is only read: name it in writes") from None


class Rows(dict):
    """Rows by name: commands["walk.velocity"] = (0.2, 0, 0) writes the numbers of a row."""

    def __missing__(self, name):
        raise KeyError(f"'{name}' is not among what the class reads or writes{nearest(name, self)}")

    def __setitem__(self, name, value):
        self[name][...] = value


class Robot:
    """What a class sees of its robot: its declared properties as attributes, signals and commands by name."""

    def __init__(self, request):
        own = self.__dict__
        own["name"], own["team"], own["model"] = request["robot"], request["team"], request["model"]
        own["seed"] = request["seed"]
        own["joints"], own["objects"] = tuple(request["joints"]), tuple(request["objects"])
        own["signals"], own["commands"], own["_rows"] = Rows(), Rows(), {}

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        raise AttributeError(
            f"'{name}' is not among the properties that the class declares in reads and writes{nearest(name, self._rows)}"
        )

    def __setattr__(self, name, value):
        if name not in self._rows:
            self.__getattr__(name)
        self._rows[name][...] = value

    def __dir__(self):
        return [*super().__dir__(), *self._rows]

    def __repr__(self):
        return f"robot '{self.name}' of the model '{self.model}' with {', '.join(self._rows) or 'no properties'}"


class Seen(Robot):
    """The same for an algorithm of a scene file, of an entity or of the whole scene."""

    def __init__(self, request):
        super().__init__(request)
        self.__dict__["outputs"] = Rows()

    def end(self, reason):
        """Ends the run after this step. Does not return."""
        raise RunEnd(one_line(reason) or "no reason given")

    def __repr__(self):
        return f"'{self.name}' with {', '.join([*self._rows, *self.signals, *self.commands, *self.outputs]) or 'no properties'}"


def frame_of(error, file):
    """File and line: the deepest of the class's own file, or else of all; without this file."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{error.filename}:{error.lineno}"
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if not is_inside(frame)]
    own = [frame for frame in frames if file and frame.filename == file] or frames
    return f"{own[-1].filename}:{own[-1].lineno}" if own else (file or "")


def is_inside(frame):
    return frame.filename == HERE or frame.filename.startswith("<frozen importlib")


def one_line(text):
    return " ".join(str(text).split())


def told(error):
    name = type(error).__name__
    try:
        message = error.msg if isinstance(error, SyntaxError) else one_line(error)
    except Exception:
        message = ""
    return f"{name}: {message}" if message else name


def explain(error, file):
    """Kind, one line, and the lines of the traceback."""
    if isinstance(error, Refusal):
        return "refused", one_line(error), []
    if isinstance(error, RunEnd):
        return "ends", one_line(error), []
    kind = "raised"
    if isinstance(error, Late):
        kind = "late"
    elif isinstance(error, Interrupted) or (isinstance(error, KeyboardInterrupt) and not OWN_INTERPRETER):
        kind = "interrupted"
    where = frame_of(error, file)
    text = where if kind == "late" else f"{where}: {told(error)}" if where else told(error)
    stack = traceback.TracebackException.from_exception(error)
    stack.stack = traceback.StackSummary.from_list([frame for frame in stack.stack if not is_inside(frame)])
    lines = "".join(stack.format()).splitlines()
    if kind != "interrupted" and not OWN_INTERPRETER:
        print(*lines, sep="\n", file=sys.stderr)  # a Python program has no report
    return kind, text, lines


def is_same(module, file):
    stamp = (os.path.getmtime(file), os.path.getsize(file))
    return getattr(module, "__file__", None) == file and getattr(module, "__murosimf_stamp__", None) == stamp


def module_of_file(name, file):
    """Loaded once for each version of the file."""
    known = sys.modules.get(name)
    if known is not None and is_same(known, file):
        return known
    folder = os.path.dirname(file) if os.path.basename(file) != "__init__.py" else os.path.dirname(os.path.dirname(file))
    if folder not in sys.path:
        sys.path.insert(0, folder)  # what the module imports from beside it
    stamp = (os.path.getmtime(file), os.path.getsize(file))
    spec = importlib.util.spec_from_file_location(name, file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        # by the text, not by a cached file of it, whose date is in whole seconds
        with open(file, "rb") as text:
            exec(compile(text.read(), file, "exec"), module.__dict__)
    except BaseException:
        if known is None:
            sys.modules.pop(name, None)
        else:
            sys.modules[name] = known
        raise
    module.__murosimf_stamp__ = stamp
    return module


def file_beside(folder, name):
    path = os.path.join(os.path.abspath(folder), *name.split("."))
    for file in (path + ".py", os.path.join(path, "__init__.py")):
        if os.path.isfile(file):
            return file
    return None


def find_module(request):
    name, file = request["module"], request["file"]
    try:
        if file:
            return module_of_file(name, os.path.abspath(file))
        if "." not in name and (beside := file_beside(request["folder"], name)):
            return module_of_file(name, beside)
        if request["folder"] not in sys.path and file_beside(request["folder"], name):
            sys.path.insert(0, os.path.abspath(request["folder"]))
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name and not name.startswith(str(error.name) + "."):
            raise not_imported(name, error) from error
        raise Refusal(f"no module '{name}' beside the scene ({request['folder']}) or on PYTHONPATH") from None
    except (Late, Interrupted, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise not_imported(name, error) from error


def not_imported(name, error):
    where = frame_of(error, None)
    return Refusal(f"module '{name}' cannot be imported: {where + ': ' if where else ''}{told(error)}")


def find_class(module, request):
    name = request["class"]
    found = getattr(module, name, None)
    file = getattr(module, "__file__", None) or request["module"]
    if found is None:
        classes = [one for one, value in vars(module).items() if inspect.isclass(value)]
        raise Refusal(f"{file}:1: no class '{name}' in it{nearest(name, classes)}")
    if not inspect.isclass(found):
        raise Refusal(f"{file}:1: '{name}' is no class")
    return found


def place_of(cls):
    try:
        return f"{inspect.getsourcefile(cls)}:{inspect.getsourcelines(cls)[1]}"
    except (OSError, TypeError):
        return cls.__module__


def arguments_of(cls, options):
    """Options as the keyword arguments that the class takes; whole numbers as int where the default is one."""
    try:
        parameters = inspect.signature(cls).parameters
    except (TypeError, ValueError):
        return dict(options)
    takes_any = any(one.kind is one.VAR_KEYWORD for one in parameters.values())
    known = [name for name, one in parameters.items() if one.kind in (one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)]
    given = {}
    for name, value in options.items():
        if name not in known and not takes_any:
            if not known:
                raise Refusal(f"{place_of(cls)}: {cls.__name__} has no options, so '{name}' is none")
            raise Refusal(f"{place_of(cls)}: {cls.__name__} has no option '{name}'{nearest(name, known)}")
        usual = parameters[name].default if name in known else None
        if type(usual) is int and type(value) is float and value.is_integer():
            value = int(value)
        given[name] = np.array(value) if type(value) is tuple else value
    missing = [name for name in known if name not in given and parameters[name].default is inspect.Parameter.empty]
    if missing:
        raise Refusal(f"{place_of(cls)}: {cls.__name__} needs the option '{missing[0]}'")
    return given


def names_in(value, cls, what):
    if isinstance(value, str):
        value = (value,)
    names = tuple(value)
    if not all(isinstance(name, str) for name in names):
        raise Refusal(f"{place_of(cls)}: '{what}' of {cls.__name__} must be names of properties, signals or commands")
    return names


def outputs_in(value, cls):
    """Name, unit and labels of each output of a sensor, as one flat list."""
    flat = []
    try:
        for name, what in dict(value).items():
            unit, labels = (what, ()) if isinstance(what, str) else what
            texts = [name, unit, *labels]
            if not all(isinstance(text, str) and text for text in texts) or any(" " in label for label in labels):
                raise TypeError
            flat += [name, unit, " ".join(labels)]
    except (TypeError, ValueError):
        raise Refusal(
            f'{place_of(cls)}: \'gives\' of {cls.__name__} must be a dictionary like {{"range": "m", "force": ("N", ("x", "y"))}}'
        ) from None
    return flat


class Loaded:
    """An object of a class, and its robot."""

    def __init__(self, request):
        module = find_module(request)
        self.cls = find_class(module, request)
        self.file = inspect.getsourcefile(self.cls) or getattr(module, "__file__", "")
        self.where = place_of(self.cls)
        self.given = arguments_of(self.cls, request["options"])
        self.of_scene_file = request["of_scene_file"]
        self.robot = Seen(request) if self.of_scene_file else Robot(request)
        self.arrays = []
        self.renew()
        self.declare()

    def renew(self):
        """An object as it begins."""
        self.object = self.cls(**self.given)

    def reseed(self, seed):
        self.robot.__dict__["seed"] = seed

    def declare(self):
        cls, made = self.cls, self.object
        if not callable(made):
            raise Refusal(f"{self.where}: {cls.__name__} has no __call__(self, robot, time)")
        usual = not self.of_scene_file and not hasattr(made, "reads") and not hasattr(made, "writes")
        self.reads = names_in(getattr(made, "reads", USUAL_READS if usual else ()), cls, "reads")
        self.writes = names_in(getattr(made, "writes", USUAL_WRITES if usual else ()), cls, "writes")
        self.rate = self.number(getattr(made, "rate", 0.0))
        self.gives = outputs_in(getattr(made, "gives", {}), cls)
        self.phase = getattr(made, "phase", "sense" if self.gives else "control")
        if self.phase not in PHASES:
            raise Refusal(f"{self.where}: '{self.phase}' is no phase of a class; there are: {', '.join(PHASES)}")
        if self.gives and not self.of_scene_file:
            raise Refusal(f"{self.where}: {cls.__name__} gives readings, so it is a sensor: name it in [[algorithms]]")
        if self.gives and self.phase != "sense":
            raise Refusal(f"{self.where}: {cls.__name__} gives readings, so its phase is 'sense', not '{self.phase}'")
        self.starts = hasattr(made, "start")
        self.saves = hasattr(made, "save") and hasattr(made, "load")

    def number(self, rate):
        try:
            rate = float(rate)
        except (TypeError, ValueError):
            rate = -1.0
        if not 0 <= rate <= 1e6:
            raise Refusal(f"{self.where}: 'rate' of {self.cls.__name__} must be a number of Hz")
        return rate

    def add(self, name, kind, shape, labels, writable):
        """Address of a new row of numbers; the class sees an array that cannot be resized."""
        memory = np.zeros(tuple(shape))
        if name in self.robot.__dict__ and kind == "property":
            raise Refusal(f"{self.where}: '{name}' is named twice")
        seen = memory.view(Row)
        if labels and len(labels) == memory.shape[0]:
            seen._numbers = {label: i for i, label in enumerate(labels)}
        seen._name = name
        seen.flags.writeable = bool(writable)
        self.arrays.append(memory)
        if kind == "property":
            self.robot.__dict__[name] = seen
            self.robot._rows[name] = seen
        else:
            dict.__setitem__(getattr(self.robot, kind + "s"), name, seen)
        return memory.ctypes.data

    def save(self):
        saved = self.object.save()
        if not isinstance(saved, bytes):
            raise TypeError(f"save returns a {type(saved).__name__}; it must return bytes")
        return saved


def load(request):
    return Loaded(request)


class Said(io.TextIOBase):
    """What classes print: lines of their robot's report; standard error outside of calls."""

    def __init__(self, say):
        self.say, self.begun = say, {}

    def writable(self):
        return True

    def write(self, text):
        thread = threading.get_ident()
        *lines, rest = (self.begun.pop(thread, "") + str(text)).split("\n")
        for line in lines:
            if not self.say(line):
                print(line, file=sys.stderr)
        if rest:
            self.begun[thread] = rest
        return len(text)

    def flush(self):
        if rest := self.begun.pop(threading.get_ident(), ""):
            self.write(rest + "\n")


def own_interpreter(say):
    """It is not that of a Python program: what classes print are lines of a report."""
    global OWN_INTERPRETER
    OWN_INTERPRETER = True
    sys.stdout = Said(say)
    sys.argv = ["murosimf"]
