# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coverage of CAD by fitted blocks: every model in a process of its own, its meshes checked against
the CAD by FreeCAD's own geometry, the outcome as tables. See scripts/coverage."""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUFFIXES = (".brep", ".brp", ".step", ".stp", ".iges", ".igs")
#: Worst scaled Jacobian that counts as good.
GOOD = 0.2
#: Strategies that are not structured.
UNSTRUCTURED = ("tet-to-hex",)


def main():
    arguments = parse()
    if arguments.model:
        print("\n" + json.dumps(measure(pathlib.Path(arguments.model), arguments.kind)))
        return
    folder = pathlib.Path(arguments.corpus)
    if not folder.is_dir():
        sys.exit(f"{folder}: no such folder; name one, or set NMGS_CORPUS")
    paths = sorted(p for p in folder.rglob("*") if p.suffix.lower() in SUFFIXES)
    paths = [p for p in paths if arguments.only in str(p.relative_to(folder))]
    kinds = ("faces", "solids") if arguments.kind == "both" else (arguments.kind,)
    jobs = [(path, kind) for kind in kinds for path in paths]
    results = {kind: {} for kind in kinds}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        futures = {pool.submit(run, p, k, arguments.limit): (p, k) for p, k in jobs}
        for future in concurrent.futures.as_completed(futures):
            path, kind = futures[future]
            outcome = future.result()
            if outcome["entities"] or outcome["problems"]:
                name = str(path.relative_to(folder))
                results[kind][name] = outcome
                print(one_line(kind, name, outcome), flush=True)
                if arguments.json:  # as it goes, so that a run that is stopped is not lost
                    text = json.dumps(results, indent=1)
                    pathlib.Path(arguments.json).write_text(text, encoding="utf-8")
    text = "\n".join(table(kind, results[kind]) for kind in kinds)
    print("\n" + text)
    if arguments.write:
        pathlib.Path(arguments.write).write_text(HEADER + text, encoding="utf-8")


def parse():
    default = os.environ.get("NMGS_CORPUS", str(ROOT.parent / "shared" / "corpus")) + "/cad"
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("corpus", nargs="?", default=default, help="folder (NMGS_CORPUS/cad)")
    parser.add_argument("--kind", choices=("faces", "solids", "both"), default="both")
    parser.add_argument("--only", default="", help="models whose path has this in it")
    parser.add_argument("--limit", type=float, default=120, help="seconds a model (120)")
    parser.add_argument("--jobs", type=int, default=2, help="models at a time (2)")
    parser.add_argument("--json", help="write all figures to this file")
    parser.add_argument("--write", help="write the tables to this file (docs/coverage.md)")
    parser.add_argument("--model", help=argparse.SUPPRESS)
    return parser.parse_args()


HEADER = """# Coverage

Made by `scripts/coverage --write docs/coverage.md` over a folder of CAD files with the default
settings. Every valid face gets quads and every valid solid hexahedra, or the table says how many
did not. *Valid*: positive Jacobians, watertight, every vertex of the CAD a node, every edge and
face covered, the area of a face within 3 % and the volume of a solid within 1 %. *Good*: besides,
the worst scaled Jacobian above 0.2. *Structured*: by any strategy but tet-to-hex.

"""


def run(path, kind, limit):
    """The outcome of one model; a crash or a time-out is one as well."""
    command = [sys.executable, __file__, "--model", str(path), "--kind", kind]
    start = time.monotonic()
    failed = {"entities": {}, "problems": [], "seconds": limit}
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit + 30)
    except subprocess.TimeoutExpired as error:
        return lost(failed, error.stdout or b"", f"not done after {limit:g} s")
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no output"])[-1]
        return lost(failed, done.stdout.encode(), f"ended with {done.returncode}: {last}")
    outcome = json.loads(done.stdout.strip().splitlines()[-1])
    if outcome["seconds"] > limit:
        outcome["problems"].append(f"took {outcome['seconds']:.0f} s")
    outcome["total"] = time.monotonic() - start
    return outcome


def lost(failed, output, reason):
    """The outcome of a run that gave none: all entities that it was to do count as not done."""
    names = []
    for line in output.decode().splitlines():
        if line.startswith("[") and not names:
            names = json.loads(line)
    entities = {name: {"method": "", "reason": reason} for name in names}
    return dict(failed, entities=entities, problems=[reason])


# One model, in its own process.


def measure(path, kind):
    import FreeCAD  # noqa: F401: before Part, or Part crashes
    import Part

    shape = Part.Shape()
    shape.read(str(path))
    parts = shape.Solids if kind == "solids" else shape.Faces
    label = "Solid" if kind == "solids" else "Face"
    names = [f"{label}{n}" for n, part in enumerate(parts, 1) if part.isValid()]
    outcome = {"entities": {}, "problems": [], "seconds": 0.0}
    if not names:
        return outcome
    print("\n" + json.dumps(names), flush=True)
    from freecad.NMGSWorkbench import nmgs

    start = time.monotonic()
    try:
        model = nmgs.fit(shape, entities=names)
    except nmgs.Error as error:
        outcome["entities"] = {name: {"method": "", "reason": str(error)} for name in names}
        outcome["problems"].append(str(error))
        return outcome
    outcome["seconds"] = time.monotonic() - start
    mesh = model.generate(force=True)
    outcome["meshing"] = time.monotonic() - start - outcome["seconds"]
    check = SolidCheck if kind == "solids" else FaceCheck
    for entry in model.report:
        outcome["entities"][entry["entity"]] = {k: entry[k] for k in ("method", "reason", "blocks")}
    done = [n for n in names if outcome["entities"].get(n, {}).get("method")]
    checker = check(shape, mesh, done)
    for name in names:
        entity = outcome["entities"].setdefault(name, {"method": "", "reason": "not in the report"})
        if entity["method"]:
            entity.update(checker.entity(name))
    outcome["problems"] += checker.whole()
    outcome["cells"] = sum(len(c) for c in mesh.cells.values())
    return outcome


class Check:
    """What is asked of a mesh over the named entities of a shape."""

    def __init__(self, shape, mesh, names):
        import numpy as np

        self.np = np
        self.shape, self.mesh, self.names = shape, mesh, names
        self.size = shape.BoundBox.DiagonalLength
        self.quads = mesh.cells.get("quad", np.empty((0, 4), int))
        self.hexes = mesh.cells.get("hexahedron", np.empty((0, 8), int))
        self.number_of_edge = self._numbers(shape.Edges)
        self.number_of_vertex = self._numbers(shape.Vertexes)
        self.number_of_face = self._numbers(shape.Faces)
        self.off_edges = {}

    @staticmethod
    def _numbers(parts):
        table = collections.defaultdict(list)
        for n, part in enumerate(parts, 1):
            table[part.hashCode()].append((part, n))

        def number(part):
            return next(n for other, n in table[part.hashCode()] if other.isSame(part))

        return number

    def group(self, name):
        return self.mesh.groups.get(name, (None, self.np.empty(0, int)))[1]

    def mesh_edges(self, cells):
        np = self.np
        pairs = np.concatenate([cells[:, [i, (i + 1) % 4]] for i in range(4)])
        return np.sort(pairs, axis=1)

    def vertices_and_edges(self, part, lines):
        """Sentences on vertices that are no nodes and edges that mesh edges do not cover."""
        np, points, bad = self.np, self.mesh.points, []
        for vertex in part.Vertexes:
            nodes = self.group(f"Vertex{self.number_of_vertex(vertex)}")
            place = np.array(vertex.Point)
            limit = max(1e-6 * self.size, vertex.Tolerance)
            if len(nodes) != 1 or np.linalg.norm(points[nodes[0]] - place) > limit:
                bad.append(f"Vertex{self.number_of_vertex(vertex)} is no node")
        lines = np.asarray(lines, int).reshape(-1, 2)
        on_edge = np.zeros(len(points), bool)
        for edge in part.Edges:
            if edge.Degenerated:
                continue
            number = self.number_of_edge(edge)
            nodes = self.group(f"Edge{number}")
            on_edge[nodes] = True
            mine = lines[on_edge[lines].all(axis=1)]
            on_edge[nodes] = False
            length = np.linalg.norm(points[mine[:, 0]] - points[mine[:, 1]], axis=1).sum()
            off = self.off_edge(edge, number, nodes)
            limit = max(1e-6 * self.size, edge.Tolerance)
            # Chords that turn by up to 60 degrees are 0.955 of their arc.
            if not 0.95 * edge.Length <= length <= 1.001 * edge.Length + limit or off > limit:
                bad.append(
                    f"Edge{number} is not covered: {length:.4g} of {edge.Length:.4g}, off {off:.2g}"
                )
        return bad

    def off_edge(self, edge, number, nodes):
        """Largest distance of the nodes from the edge, of some hundred of them where there are
        more; once an edge, for all the faces that it bounds."""
        import FreeCAD
        import Part

        if number not in self.off_edges:
            some = nodes[:: max(1, len(nodes) // 200)]
            places = [Part.Vertex(FreeCAD.Vector(*self.mesh.points[n])) for n in some]
            self.off_edges[number] = max((edge.distToShape(p)[0] for p in places), default=0.0)
        return self.off_edges[number]

    def face_lines(self, faces):
        rows = [self.group(f"Face{self.number_of_face(face)}") for face in faces]
        cells = self.quads[self.np.concatenate(rows)] if rows else self.quads[:0]
        return self.np.unique(self.mesh_edges(cells), axis=0).tolist() if len(cells) else []

    def face_problem(self, face):
        np, number = self.np, self.number_of_face(face)
        rows = self.group(f"Face{number}")
        if not len(rows):
            return f"Face{number} is not covered"
        cells = self.quads[rows]
        p = self.mesh.points
        normals = np.cross(p[cells[:, 2]] - p[cells[:, 0]], p[cells[:, 3]] - p[cells[:, 1]])
        area = 0.5 * np.linalg.norm(normals, axis=1).sum()
        if abs(area - face.Area) > 0.03 * face.Area + 1e-9 * self.size**2:
            return f"Face{number} has area {area:.4g} instead of {face.Area:.4g}"
        return ""


class SolidCheck(Check):
    def __init__(self, shape, mesh, names):
        super().__init__(shape, mesh, names)
        self.jacobian = mesh.quality().get("hexahedron")

    def entity(self, name):
        np, solid = self.np, self.shape.Solids[int(name[5:]) - 1]
        cells = self.group(name)
        if not len(cells):
            return {"worst": -1.0, "problems": ["no hexahedra"]}
        worst = float(self.jacobian[cells].min())
        problems = [] if worst > 0 else [f"worst scaled Jacobian {worst:.3g}"]
        volume = hex_volume(np, self.mesh.points[self.hexes[cells]]).sum()
        error = abs(volume - abs(solid.Volume)) / max(abs(solid.Volume), 1e-300)
        if error > 0.01:
            problems.append(f"volume error {error:.2%}")
        problems += filter(None, (self.face_problem(face) for face in solid.Faces))
        lines = self.face_lines(solid.Faces)
        of_faces = {self.number_of_edge(edge) for face in solid.Faces for edge in face.Edges}
        inside = [n for n in map(self.number_of_edge, solid.Edges) if n not in of_faces]
        if inside:  # edges of hexahedra cover these, not edges of the faces' quads
            corners = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (3, 2, 6, 7))
            rows = np.concatenate([self.hexes[cells][:, list(c)] for c in corners])
            own = np.unique(np.concatenate([self.group(f"Edge{n}") for n in inside]))
            rows = np.unique(self.mesh_edges(rows), axis=0)
            lines = lines + rows[np.isin(rows, own).any(axis=1)].tolist()
        problems += self.vertices_and_edges(solid, lines)
        return {"worst": worst, "volume_error": error, "problems": problems}

    def whole(self):
        """Inner faces shared by two hexahedra, the others closed and on CAD faces."""
        np = self.np
        if not len(self.hexes):
            return []
        sides = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
        faces = np.sort(np.concatenate([self.hexes[:, s] for s in sides]), axis=1)
        unique, count = np.unique(faces, axis=0, return_counts=True)
        problems = []
        if (count > 2).any():
            problems.append(f"{(count > 2).sum()} faces are shared by three hexahedra or more")
        outer = unique[count == 1]
        quads = np.unique(np.sort(self.quads, axis=1), axis=0)
        known = set(map(tuple, quads.tolist()))
        loose = sum(tuple(row) not in known for row in outer.tolist())
        if loose:
            problems.append(f"{loose} outer faces are on no CAD face")
        kinds = set(self.mesh.cells) - {"hexahedron", "quad"}
        if kinds:
            problems.append(f"cells of other kinds: {', '.join(sorted(kinds))}")
        return problems


class FaceCheck(Check):
    def __init__(self, shape, mesh, names):
        super().__init__(shape, mesh, names)
        self.jacobian = mesh.quality().get("quad")

    def entity(self, name):
        face = self.shape.Faces[int(name[4:]) - 1]
        cells = self.group(name)
        if not len(cells):
            return {"worst": -1.0, "problems": ["no quads"]}
        worst = float(self.signed(face, cells).min())
        problems = [] if worst > 0 else [f"worst scaled Jacobian {worst:.3g}"]
        problems += filter(None, [self.face_problem(face)])
        problems += self.vertices_and_edges(face, self.face_lines([face]))
        return {"worst": worst, "problems": problems}

    def signed(self, face, cells):
        """Smallest scaled Jacobian of each quad's corners against the face's own normal there."""
        np = self.np
        import FreeCAD

        p = self.mesh.points[self.quads[cells]]
        worst = np.full(len(cells), 2.0)
        surface = face.Surface
        sign = -1.0 if face.Orientation == "Reversed" else 1.0
        centres = p.mean(axis=1)
        normals = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
        for i in self.doubtful(cells, p, normals):
            u, v = surface.parameter(FreeCAD.Vector(*centres[i]))
            try:
                normals[i] = sign * np.array(surface.normal(u, v))
            except Exception:  # a pole has no normal
                pass
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        for k in range(4):
            a = p[:, (k + 1) % 4] - p[:, k]
            b = p[:, k - 1] - p[:, k]
            length = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
            corner = (np.cross(a, b) * normals).sum(axis=1) / np.maximum(length, 1e-300)
            # The surface may turn within a coarse quad: only what it folds counts.
            flat = np.linalg.norm(np.cross(a, b), axis=1) / np.maximum(length, 1e-300)
            worst = np.minimum(worst, np.where(corner > 0, flat, corner))
        return worst

    def doubtful(self, cells, p, normals):
        """Quads whose side the surface's normal has to tell: those with a corner that is flat or
        turned over, those that turn sharply against a neighbour, and a hundred of the others: a
        fold has a rim of such quads, unless the whole face lies upside down."""
        np = self.np
        unit = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        doubt = np.zeros(len(cells), bool)
        doubt[:: max(1, len(cells) // 100)] = True
        for k in range(4):
            a = p[:, (k + 1) % 4] - p[:, k]
            b = p[:, k - 1] - p[:, k]
            length = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
            doubt |= (np.cross(a, b) * unit).sum(axis=1) < 0.05 * length
        pairs = self.mesh_edges(self.quads[cells])
        owner = np.tile(np.arange(len(cells)), 4)
        order = np.lexsort((pairs[:, 1], pairs[:, 0]))
        same = (pairs[order[1:]] == pairs[order[:-1]]).all(axis=1)
        one, two = owner[order[1:]][same], owner[order[:-1]][same]
        sharp = np.flatnonzero((unit[one] * unit[two]).sum(axis=1) < 0.5)
        sharp = sharp[:: max(1, len(sharp) // 500)]  # a surface may be full of ripples
        doubt[one[sharp]] = doubt[two[sharp]] = True
        return np.flatnonzero(doubt)

    def whole(self):
        """Over an edge, the quads on both sides use the same mesh edges."""
        problems = []
        kinds = set(self.mesh.cells) - {"quad"}
        if kinds:
            problems.append(f"cells of other kinds: {', '.join(sorted(kinds))}")
        uses = collections.Counter()
        for name in self.names:
            cells = self.quads[self.group(name)]
            uses.update(map(tuple, self.mesh_edges(cells).tolist()))
        faces_of = collections.Counter()
        for name in self.names:
            face = self.shape.Faces[int(name[4:]) - 1]
            ordered = [self.number_of_edge(e) for wire in face.Wires for e in wire.OrderedEdges]
            # A seam counts twice, and so does an edge inside the face: both its sides are of the
            # one face. (OpenCASCADE's own test takes an edge between two faces on one surface for a
            # seam, and its walk goes along the boundary only; a face that is itself "Internal"
            # hands that on to its edges, and then there is nothing to walk along.)
            for edge in face.Edges:
                number = self.number_of_edge(edge)
                inner = edge.Orientation == "Internal" and face.Orientation != "Internal"
                faces_of[number] += 2 if inner else max(1, ordered.count(number))
        beside = collections.defaultdict(list)
        for (a, b), count in uses.items():
            beside[a].append((b, count))
        for number, count in faces_of.items():
            nodes = set(self.group(f"Edge{number}").tolist())
            inner = [n for a in nodes for b, n in beside[a] if b in nodes]
            wrong = sum(n not in (count, 2) for n in inner)
            if wrong and count > 1:
                problems.append(f"Edge{number}: {wrong} mesh edges are not shared by its faces")
        outer = [u for u, n in uses.items() if n == 1]
        on_edges = set()
        for number in faces_of:
            on_edges.update(self.group(f"Edge{number}").tolist())
        loose = sum(not (a in on_edges and b in on_edges) for a, b in outer)
        if loose:
            problems.append(f"{loose} open mesh edges lie on no CAD edge")
        return problems


def hex_volume(np, p):
    """Volumes of hexahedra (M, 8, 3) with bilinear faces, by 2 x 2 x 2 Gauss points, which are
    exact for them."""
    corners = np.array([(a, b, c) for c in (-1, 1) for b in (-1, 1) for a in (-1, 1)], float)
    corners = corners[[0, 1, 3, 2, 4, 5, 7, 6]]
    total = np.zeros(len(p))
    for g in corners / 3**0.5:
        d = np.empty((8, 3))
        for k in range(3):
            others = [j for j in range(3) if j != k]
            d[:, k] = corners[:, k] / 8 * np.prod(1 + corners[:, others] * g[others], axis=1)
        total += np.linalg.det(np.einsum("mni,nk->mik", p, d))
    return total


# Tables.


def entity_state(entity):
    if not entity["method"]:
        return "none"
    if entity.get("problems"):
        return "invalid"
    return "good" if entity["worst"] > GOOD else "valid"


def one_line(kind, name, outcome):
    states = collections.Counter(entity_state(e) for e in outcome["entities"].values())
    methods = collections.Counter(e["method"] or "-" for e in outcome["entities"].values())
    worst = min((e.get("worst", -1) for e in outcome["entities"].values()), default=-1)
    first = [p for e in outcome["entities"].values() for p in e.get("problems", [])]
    first += [e["reason"] for e in outcome["entities"].values() if not e["method"]]
    notes = "; ".join((outcome["problems"] + first)[:2])[:160]
    return (
        f"{kind:6} {name:60} {outcome['seconds']:6.1f}s {dict(states)} {dict(methods)} "
        f"worst {worst:.3f} {notes}"
    )


def table(kind, results):
    folders = collections.defaultdict(list)
    for name, outcome in results.items():
        folder = name.split("/")[0]
        folders[folder].append(outcome)
        # HexMe's own models are in two folders.
        if "hexme" in name:
            folders["*all of hexme*"].append(outcome)
        folders["**all**"].append(outcome)
    title = f"## {kind.capitalize()}\n\n"
    head = ["folder", "models", kind, "valid", "good", "median s"]
    if kind == "solids":
        head[5:5] = ["structured and good", "models wholly so"]
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    for folder, outcomes in sorted(folders.items(), key=lambda item: item[0].strip("*")):
        entities = [e for o in outcomes for e in o["entities"].values()]
        broken = [o for o in outcomes if o["problems"]]
        states = [entity_state(e) for e in entities]
        valid = sum(s in ("good", "valid") for s in states)
        good = states.count("good")
        row = [folder, len(outcomes), len(entities), share(valid, states), share(good, states)]
        if kind == "solids":
            fine = [
                s == "good" and e["method"] not in UNSTRUCTURED for s, e in zip(states, entities)
            ]
            whole = [
                o not in broken
                and all(
                    entity_state(e) == "good" and e["method"] not in UNSTRUCTURED
                    for e in o["entities"].values()
                )
                for o in outcomes
            ]
            row += [share(sum(fine), fine), share(sum(whole), whole)]
        row.append(f"{statistics.median(o['seconds'] for o in outcomes):.2f}")
        lines.append("| " + " | ".join(map(str, row)) + " |")
    return title + "\n".join(lines) + "\n"


def share(count, of):
    """Rounded down: all but one of many are not 100 %."""
    percent = 1000 * count // max(len(of), 1) / 10
    return f"{count} ({percent:g} %)"


if __name__ == "__main__":
    main()
