"""The drafted skirt is sewn round the form and fitted: zones of tension, seams, report.

    .venv/bin/python examples/skirt/run.py [FOLDER] [--quick]      results go to FOLDER, default build/skirt
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "drafting"))
from fitting import fitted

if __name__ == "__main__":
    fitted("skirt", __doc__, quick=["--cell=0.02", "--length=0.4"], full=["--cell=0.01"])
