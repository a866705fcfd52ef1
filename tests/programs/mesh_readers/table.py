"""Opens the meshes of a surface in every program and prints a table; exit code 1 where one errs.

usage: table.py FOLDER NAME FORMAT...
FOLDER has NAME.json, what discmc measures, and NAME.stl, .ply, .obj ...
"""
import json
import os
import subprocess
import sys

from programs import PROGRAMS

HERE = os.path.dirname(os.path.abspath(__file__))


def output_of(program, file):
    """In a process of its own, which may crash."""
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
        # Some programs sum in 32-bit floats.
        if abs(figures["volume"] * unit / volume - 1) > 2e-5:
            faults.append(f"volume {figures['volume'] * unit:.0f}")
    return ", ".join(faults) or "ok"


def main(folder, name, formats):
    with open(f"{folder}/{name}.json") as file:
        volumes = [surface["volume_mm3"] for surface in json.load(file)]
    volume = sum(volumes)
    triangles = output_of("VTK", f"{folder}/{name}.{formats[0]}").get("triangles", 0)
    print(f"{name}: {triangles:,} triangles that enclose {volume:,.0f} mm3\n")
    print("| program |", " | ".join("." + format for format in formats), "|")
    print("|---|" + "---|" * len(formats))
    is_good = True
    for program, (_, readable) in PROGRAMS.items():
        # OpenSCAD unites touching objects.
        if not set(formats) & set(readable) or (program == "OpenSCAD" and len(volumes) > 1):
            continue
        cells = []
        for format in formats:
            file = f"{folder}/{name}.{format}"
            cell = "-"
            if format in readable:
                cell = judged(output_of(program, file), file, triangles, volume)
                is_good = is_good and cell == "ok"
            cells.append(cell)
        print("|", program, "|", " | ".join(cells), "|", flush=True)
    print()
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
