# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table and plots of the suite's errors against degrees of freedom. See scripts/verify."""

import argparse
import json
import os
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(ROOT, "tests"), os.path.join(ROOT, "tests", "verification")]

import problems  # noqa: E402
import study  # noqa: E402

COLOURS = {
    "hex20": "#1b6ca8",
    "hex20 full": "#7fb2d9",
    "TetGen tet10": "#c8553d",
    "Gmsh tet10": "#7a9e3f",
}
#: Problems that only hexahedra are shown for: pieces laid out to be distorted, and a given mesh.
HEXAHEDRA_ONLY = ("beam-parallelogram", "beam-trapezoid", "fv52")


#: Problems whose notes another one has.
REPEATED = ("beam-parallelogram", "beam-trapezoid", "plate-2", "plate-6")


def measured(problem, kept):
    """{method: [Run, ...]}; kept: runs of an earlier time, by problem, method and size."""
    methods = list(study.METHODS)
    if problem.name.startswith(HEXAHEDRA_ONLY):
        methods = [m for m in methods if m.startswith("hex20")]
    result = {}
    for method in methods:
        sizes = problem.sizes if method.startswith("hex20") else problem.tet_sizes
        runs = []
        for size in sizes:
            key = f"{problem.name}|{method}|{size}"
            if key not in kept:
                start = time.time()
                kept[key] = vars(study.run(problem, size, method))
                error = 100 * kept[key]["error"]
                print(f"{key:<48} {kept[key]['freedoms']:>8} {error:>8.2f} %"
                      f" {time.time() - start:>6.1f} s", flush=True)  # fmt: skip
            runs.append(study.Run(**kept[key]))
        result[method] = sorted(runs, key=lambda entry: entry.freedoms)
    return result


def plot(path, everything):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "nmgs"
    from matplotlib import pyplot

    shown = [(p, r) for p, r in everything if p.published is None]
    columns = 4
    rows = -(-len(shown) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(4 * columns, 2.9 * rows), squeeze=False)
    for axis in axes.ravel()[len(shown):]:  # fmt: skip
        axis.axis("off")
    for axis, (problem, runs) in zip(axes.ravel(), shown):
        for method, series in runs.items():
            axis.loglog(
                [entry.freedoms for entry in series],
                [max(100 * abs(entry.error), 1e-3) for entry in series],
                marker="o",
                markersize=3.5,
                linewidth=1.3,
                color=COLOURS[method],
                label=method,
            )
        axis.axhline(100 * study.WANTED, color="#666666", linewidth=0.8, linestyle="--")
        axis.set_title(problem.name, fontsize=9)
        axis.grid(True, which="major", linewidth=0.3)
        axis.tick_params(labelsize=7)
    for axis in axes[:, 0]:
        axis.set_ylabel("error, %", fontsize=8)
    for axis in axes[-1]:
        axis.set_xlabel("degrees of freedom", fontsize=8)
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0.02, 1, 1))
    figure.savefig(path, metadata={"Date": None} if path.endswith(".svg") else None)


def _documented(problem, runs, method="hex20"):
    return next(entry for entry in runs[method] if entry.size == problem.size)


def _figure(value):
    return f"{value:.5g}"


def page(everything):
    """The text of docs/verification.md."""
    lines = [HEAD]
    lines.append("| problem | quantity | reference | size | elements | DOF | value | error |")
    lines.append("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for problem, runs in everything:
        if problem.published is None:
            at = _documented(problem, runs)
            lines.append(
                f"| {problem.title} | {problem.quantity} | {_figure(problem.reference)} | "
                f"{problem.size} | {at.elements} | {at.freedoms} | {_figure(at.value)} | "
                f"{100 * at.error:+.2f} % |"
            )
    lines += ["", PLATES, ""]
    lines.append("| frequency | closed form | NAFEMS, 4 x 4 x 1 | here | against NAFEMS | "
                 "against the closed form |")  # fmt: skip
    lines.append("| ---: | ---: | ---: | ---: | ---: | ---: |")
    for problem, runs in everything:
        if problem.published is not None:
            at = _documented(problem, runs, "hex20 full")
            lines.append(
                f"| {problem.name[5:]} | {problem.reference} | {problem.published} | "
                f"{at.value:.3f} | {100 * (at.value / problem.published - 1):+.2f} % | "
                f"{100 * at.error:+.2f} % |"
            )
    lines += ["", NEEDED, ""]
    methods = list(study.METHODS)
    lines.append("| problem | " + " | ".join(methods) + " | TetGen / hex20 | Gmsh / hex20 |")
    lines.append("| --- | " + " | ".join(["---:"] * (len(methods) + 2)) + " |")
    ratios = {"TetGen tet10": [], "Gmsh tet10": []}
    for problem, runs in everything:
        if problem.name.startswith(HEXAHEDRA_ONLY):
            continue
        needs = {method: study.needed(runs[method]) for method in methods}
        cells = [str(needs[m]) if needs[m] else f"> {runs[m][-1].freedoms}" for m in methods]
        for method, found in ratios.items():
            known = needs[method] and needs["hex20"]
            cells.append(f"{needs[method] / needs['hex20']:.1f}" if known else "")
            if known:
                found.append(needs[method] / needs["hex20"])
        lines.append(f"| {problem.name} | " + " | ".join(cells) + " |")
    means = {m: _geometric_mean(found) for m, found in ratios.items()}
    lines += [
        "",
        f"Geometric mean of the ratios: TetGen's tetrahedra need {means['TetGen tet10']:.1f} times "
        f"the degrees of freedom of the hexahedra, Gmsh's {means['Gmsh tet10']:.1f} times.",
        "",
        "![Error against degrees of freedom](pictures/verification.svg)",
        "",
        "## Notes",
        "",
    ]
    for problem, _ in everything:
        if problem.note and not problem.name.startswith(REPEATED):
            lines.append(f"- {problem.name}: {problem.note}")
    lines += ["", "## Sources", ""]
    lines += [f"- {source}" for source in dict.fromkeys(p.source for p, _ in everything)]
    return "\n".join(lines) + "\n"


def _geometric_mean(values):
    product = 1.0
    for value in values:
        product *= value
    return product ** (1 / len(values)) if values else float("nan")


HEAD = """# Verification

`scripts/verify` makes this page. Each problem's CAD is made with FreeCAD's Part, blocks are laid
over it by `nmgs.fit`, the 20-node hexahedra go through `nmgs.write` (`.inp`) to CalculiX, and a
number with a known answer is read. The meshes are of one element size everywhere; nothing is
refined by hand. `tests/verification` holds every figure of the first table to 2 %, and runs the
patch test and the rigid body modes of every element type in distorted meshes: hexahedra, wedges,
pyramids, tetrahedra, quads and triangles, linear and quadratic, and all volumes together.

## 20-node hexahedra at the documented size

Reduced integration (C3D20R), as CalculiX's manual recommends; the study below has full integration
(C3D20) beside it.
"""
PLATES = """## NAFEMS FV52

The plate is held along its bottom edges, by lines: under a line a solid gives way without limit as
the mesh gets finer, so the mesh is part of the problem. On NAFEMS's own mesh (4 x 4 x 1 elements of
20 nodes, full integration) the figures are NAFEMS's. Frequency 4 is 2.4 % below the closed form of
plate theory there too. The same plate held on its side faces, as plate theory means it, is in the
table above.
"""
NEEDED = """## Degrees of freedom for 2 %

The smallest mesh of the series that is within 2 % of the reference, as all finer ones are. "hex20
full" are the hexahedra of full integration. TetGen: `nmgs.tetrahedralize(shape, "pq1.4a...o2",
snap=True)`. Gmsh: FreeCAD's own FEM mesh object, second order. All by CalculiX with the same loads.
Where the coarsest mesh of a series is good already, the figure is that mesh's.
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="", help="part of the problems' names")
    parser.add_argument("--json", default=os.path.join(ROOT, "build", "verification.json"))
    parser.add_argument("--docs", default=os.path.join(ROOT, "docs"))
    parser.add_argument("--fresh", action="store_true", help="use no runs of an earlier time")
    options = parser.parse_args()
    kept = {}
    if os.path.exists(options.json) and not options.fresh:
        with open(options.json, encoding="utf-8") as file:
            kept = json.load(file)
    everything = []
    for problem in problems.PROBLEMS:
        if options.only in problem.name:
            everything.append((problem, measured(problem, kept)))
            with open(options.json, "w", encoding="utf-8") as file:
                json.dump(kept, file, indent=1)
    if options.only:
        return 0
    with open(os.path.join(options.docs, "verification.md"), "w", encoding="utf-8") as file:
        file.write(page(everything))
    plot(os.path.join(options.docs, "pictures", "verification.svg"), everything)
    worst = max(abs(_documented(p, r).error) for p, r in everything if p.published is None)
    print(f"largest error at the documented sizes {100 * worst:.2f} %; wanted: at most 2 %")
    return 0 if worst <= study.WANTED else 1


if __name__ == "__main__":
    sys.exit(main())
