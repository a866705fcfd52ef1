"""Opens the meshes of a surface in every program and prints a table; exit code 1 where one errs.

usage: table.py FOLDER NAME X,Y,Z
FOLDER has NAME.jsonl, the merged polygons, and NAME.stl, .ply, .obj ...; X,Y,Z is the spacing.
"""
import json
import os
import subprocess
import sys

from programs import PROGRAMS

HERE = os.path.dirname(os.path.abspath(__file__))
FORMATS = ["stl", "ply", "obj", "glb", "3mf", "vtp"]


def true_volume(lines, spacing):
    """Of merged polygons in half-steps, by their rings, in integers. Units: cubic millimetres."""
    sixfold = 0
    for line in lines:
        for ring in json.loads(line)["rings"]:
            x0, y0, z0 = ring[0]
            for (x1, y1, z1), (x2, y2, z2) in zip(ring[1:], ring[2:]):
                sixfold += (x0 * (y1 * z2 - z1 * y2) + y0 * (z1 * x2 - x1 * z2)
                            + z0 * (x1 * y2 - y1 * x2))
    return abs(sixfold / 48 * spacing[0] * spacing[1] * spacing[2])


def told_by(program, file):
    """A process of its own, as it may not come back."""
    done = subprocess.run([sys.executable, f"{HERE}/programs.py", program, file],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for line in done.stdout.splitlines():
        if line.startswith("figures "):
            return json.loads(line[len("figures "):])
    return {"error": (done.stderr.strip().splitlines() or ["ended without a word"])[-1]}


def judged(figures, file, triangles, volume):
    if "error" in figures:
        return figures["error"]
    faults = []
    if figures["triangles"] != triangles:
        faults.append(f"{figures['triangles']} triangles")
    if figures["closed"] is False:
        faults.append("open")
    if figures["volume"] is not None:
        unit = 1e9 if file.endswith(".glb") else 1  # cubic metres
        # Some add up in 32-bit floats.
        if abs(figures["volume"] * unit / volume - 1) > 2e-5:
            faults.append(f"volume {figures['volume'] * unit:.0f}")
    return ", ".join(faults) or "ok"


def main(folder, name, spacing):
    with open(f"{folder}/{name}.jsonl") as lines:
        volume = true_volume(lines, spacing)
    triangles = (os.path.getsize(f"{folder}/{name}.stl") - 84) // 50
    print(f"{name}: {triangles:,} triangles that enclose {volume:,.0f} mm3\n")
    print("| program |", " | ".join("." + format for format in FORMATS), "|")
    print("|---|" + "---|" * len(FORMATS))
    is_good = True
    for program, (_, formats) in PROGRAMS.items():
        cells = []
        for format in FORMATS:
            file = f"{folder}/{name}.{format}"
            cell = "-"
            if format in formats:
                cell = judged(told_by(program, file), file, triangles, volume)
                is_good = is_good and cell == "ok"
            cells.append(cell)
        print("|", program, "|", " | ".join(cells), "|", flush=True)
    print()
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], [float(size) for size in sys.argv[3].split(",")]))
