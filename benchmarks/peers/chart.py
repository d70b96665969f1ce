"""A bar chart of a race: how many times as long as ours each engine took, at its fastest setting, in each scene (gnuplot)."""
import subprocess

from running import fail

SETTINGS = """set terminal pngcairo noenhanced size 1100,520 font 'sans,11' background '#ffffff'
set output "{file}"
set logscale y
set yrange [0.8:*]
set ylabel "times as long as MuRoSimF, articulated_dynamics"
set grid y
set key top left horizontal
set xtics rotate by -35
set style data histograms
set style histogram clustered gap 1.5
set style fill solid 0.85 noborder
set arrow from graph 0, first 1 to graph 1, first 1 nohead dashtype 2
"""


def bars(document):
    """Scenes in their order; engine: scene: ratio."""
    names, engines = [], {}
    for part in document["parts"].values():
        for row in part["rows"]:
            if row.get("ours", True) or "times_as_long" not in row:
                continue
            name = f"{row['scene']} of {row['robots']}" if "robots" in row else row["scene"]
            name += f", {row['threads']} threads" if row.get("threads", 1) > 1 else ""
            names += [name] if name not in names else []
            of_engine = engines.setdefault(row["engine"].split()[0], {})
            of_engine[name] = min(row["times_as_long"], of_engine.get(name, row["times_as_long"]))
    return names, engines


def draw(document, file):
    names, engines = bars(document)
    if not engines:
        fail("nothing to draw: no other engine took part")
    lines = ["$race << END", "scene " + " ".join(engines)]
    for name in names:
        values = [f"{of_engine[name]:.3g}" if name in of_engine else "-" for of_engine in engines.values()]
        lines.append(" ".join([f'"{name}"', *values]))
    plots = ", ".join(f'$race using {i + 2}{":xtic(1)" if i == 0 else ""} title columnheader' for i in range(len(engines)))
    script = "\n".join([SETTINGS.format(file=file), "set datafile missing '-'", *lines, "END", f"plot {plots}", ""])
    try:
        done = subprocess.run(["gnuplot"], input=script, capture_output=True, text=True, check=False)
    except OSError:
        fail("charts need the program gnuplot, which does not start here (Debian and Ubuntu: gnuplot-nox)")
    if done.returncode != 0:
        fail(f"gnuplot: {done.stderr.strip().splitlines()[-1] if done.stderr.strip() else 'it says nothing'}")
