"""docs/gallery_robots.md: every robot of the wheels with its picture, and what it can."""

import itertools
import subprocess
import tempfile
from pathlib import Path

try:
    from PIL import Image, ImageChops
except ImportError:
    Image = None

from zoo.trials import LEVELS
from zoo.wheels import WHEELS

SIZE = (150, 170)  # [px] of a picture, width and height
HEAD = """# Robots of others

Every robot file of some packages of PyPI, read as it is, by `scripts/robot_zoo --gallery`; the files belong to their authors and
are not part of this project. Joints are those that move; a humanoid has two legs of five hinges or more, with soles. **s** stands
10 s, **w** walks 0.1 m/s for 10 s (no fall, 0.5 to 1.3 m forward, at most 0.5 m to the side), with servos and a gait that are
guessed from the file alone ([robots.md](robots.md)), at `kinematic_walking`, `simplified_dynamics`, `full_dynamics`,
`articulated_dynamics`; `-` does not. Robots that are no humanoids have no such columns.
"""


def last_view(whole):
    """The last of the four views that `check` draws side by side, which the three widest gaps part."""
    views = whole.crop((0, whole.height // 10, whole.width, whole.height))  # without the title
    background = Image.new("RGB", views.size, views.getpixel((0, views.height - 1)))
    shape = ImageChops.difference(views, background).convert("L").point(lambda level: 255 if level > 12 else 0)
    columns = [x for x in range(views.width) if shape.crop((x, 0, x + 1, views.height)).getbbox()]
    if not columns:
        return views
    gaps = sorted(((right - left, right) for left, right in itertools.pairwise(columns)), reverse=True)
    left = max((right for width, right in gaps[:3] if width > 1), default=columns[0])
    _, top, _, bottom = shape.crop((left, 0, views.width, views.height)).getbbox()
    return views.crop((left, top, columns[-1] + 1, bottom))


def draw(program, file, out):
    """The last view of the picture of `check`: the robot from an angle. False where nothing can be drawn."""
    if Image is None:
        return False
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "robot.png"
        subprocess.run([program, "check", str(file), "--picture", str(picture)], capture_output=True, check=False)
        if not picture.is_file():
            return False
        view = last_view(Image.open(picture).convert("RGB"))
    view.thumbnail(SIZE)
    out.parent.mkdir(parents=True, exist_ok=True)
    view.save(out, quality=80)
    return True


def marks(result):
    """A column for each level: what the robot can there."""
    if not result.get("moves"):
        return [" "] * len(LEVELS)
    cells = []
    for level in LEVELS:
        trial = result["moves"][level]
        cells.append(("s" if trial["stands"]["ok"] else "-") + ("w" if trial["walks"]["ok"] else "-"))
    return cells


def lines_of(name, results, pictures):
    yield f"\n## {name} {WHEELS[name]}\n"
    yield "| | file | mass kg | joints | kinematic | simplified | full | articulated |"
    yield "|---|---|---|---|---|---|---|---|"
    for result in results:
        if not result["read"]:
            continue
        picture = pictures.get(result["file"], "")
        shown = f"![]({picture})" if picture else ""
        cells = [shown, result["short"], f'{result["mass_kg"]:.4g}', str(result["joints"]), *marks(result)]
        yield "| " + " | ".join(cells) + " |"
    refused = [result for result in results if not result["read"] and result.get("counts")]
    if refused:
        yield "\nNot read:\n"
        for result in refused:
            yield f'* {result["short"]}: {result["error"]}'


def write(program, page, by_wheel):
    """Draws all and writes the page."""
    folder = page.parent / "gallery"
    text = [HEAD]
    for name, results in by_wheel.items():
        if not results:
            continue
        pictures = {}
        for result in results:
            picture = folder / (name + "_" + result["short"].replace("/", "_").rsplit(".", 1)[0] + ".jpg")
            if result["read"] and draw(program, result["file"], picture):
                pictures[result["file"]] = f"gallery/{picture.name}"
        text.extend(lines_of(name, results, pictures))
    page.write_text("\n".join(text).replace("\n\n\n", "\n\n") + "\n")
