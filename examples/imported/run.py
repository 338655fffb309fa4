"""A sewing pattern in GarmentCode's JSON, imported, sewn round the dress form and fitted.

    .venv/bin/python examples/imported/run.py [FOLDER] [--quick]      results go to FOLDER, default build/imported
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "drafting"))
from fitting import check, command_line, fit
from look import picture
from stage import drape

HERE = Path(__file__).resolve().parent


def main():
    options = command_line(__doc__, "imported")
    folder, scene = options.folder, options.folder / "tunic.toml"
    folder.mkdir(parents=True, exist_ok=True)
    drape("form", "-o", folder / "form.obj")
    drape("import", HERE / "tunic.json", "--body", folder / "form.obj", "-o", scene, "--cell", 0.025 if options.quick else 0.01)
    end = fit(scene, folder)
    picture(folder / "run", folder / "imported.png", field="tension_warp", views=["front", "back", "oblique"])
    check(end, rest=1e-3)  # it hangs loose and swings for long


if __name__ == "__main__":
    main()
