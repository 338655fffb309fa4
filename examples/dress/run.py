"""The drafted dress is sewn round the form and fitted: zones of tension, seams, report.

    .venv/bin/python examples/dress/run.py [FOLDER] [--quick]      results go to FOLDER, default build/dress
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "drafting"))
from fitting import fitted

if __name__ == "__main__":
    fitted("dress", __doc__, quick=["--cell=0.014", "--length=0.3"], full=["--cell=0.01"])
