"""Saved states on disk: another process goes on with the bits of a run that never stopped."""
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from bodies import sheet_over_ball
from fmpy.fmi1 import FMICallException
from master import DISCARD, OK, Instance, same_bits
from scenes import damped_sheet, driven_sheet, flag, pole_path, swinging_sheet, two_strips

SAVED, END, Q = 0.03, 0.06, 0.001  # s

# Arguments: FMU, saved state, end. Prints all outputs at the end, in bytes of doubles.
CONTINUE = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[4])
import test_states
test_states.go_on(*sys.argv[1:4])
"""


def inputs_at(cloth, time):
    if "pin.pole.position[1]" in cloth.fmu.variables:
        cloth.drive(pole_path(time))


def advance(cloth, until):
    for k in range(round(cloth.time / Q), round(until / Q)):
        cloth.time = k * Q  # computed, so that both processes give the same inputs
        inputs_at(cloth, (k + 1) * Q)
        assert cloth.step(Q) == OK, cloth.log


def ends(cloth):
    return cloth.get(*cloth.fmu.outputs())


def save(cloth):
    state = cloth.slave.getFMUState()
    data = cloth.slave.serializeFMUState(state)
    cloth.slave.freeFMUState(state)
    return data


def go_on(fmu_file, state_file, end):
    from master import Fmu

    with Instance(Fmu(fmu_file)) as cloth:
        cloth.slave.setFMUState(cloth.slave.deSerializeFMUstate(Path(state_file).read_bytes()))
        cloth.time = SAVED
        advance(cloth, float(end))
        sys.stdout.buffer.write(ends(cloth).tobytes())


SCENES = {
    "swinging": lambda folder: swinging_sheet(energy=True),
    "air and damping": lambda folder: flag(damping=1.0),
    "damped springs": lambda folder: damped_sheet(),
    "driven clamp": lambda folder: driven_sheet(),
    "order 4": lambda folder: swinging_sheet(order=4),
    "sewing": lambda folder: two_strips(),
    "fit": lambda folder: two_strips(mode="fit"),
    "body and friction": lambda folder: sheet_over_ball(folder),
    "self-contact": lambda folder: sheet_over_ball(folder, self_contact=True),
}


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_another_process_goes_on(pack, tmp_path, scene):
    """Saved in the middle of a ramp; the file goes to another process, with another copy of the FMU."""
    fmu = pack(scene(tmp_path), nodes="all")
    with Instance(fmu) as cloth:
        cloth.initialize()
        advance(cloth, SAVED - 0.01)
        assert cloth.set("parameter_ramp", 0.02) == OK and cloth.set("gravity[1]", 3.0) == OK
        advance(cloth, SAVED)
        data = save(cloth)
        advance(cloth, END)
        expected = ends(cloth)
    (tmp_path / "state").write_bytes(data)
    (tmp_path / "copy.fmu").write_bytes(fmu.file.read_bytes())
    done = subprocess.run([sys.executable, "-c", CONTINUE, tmp_path / "copy.fmu", tmp_path / "state", str(END),
                           Path(__file__).parent], capture_output=True)
    assert done.returncode == 0, done.stderr.decode()
    assert same_bits(np.frombuffer(done.stdout), expected)


def test_states_of_others_are_refused(pack):
    """Of another scene, of the same with other numbers, cut off, and of no scene at all."""
    foreign = []
    for name, scene in {"another": driven_sheet(), "other numbers": swinging_sheet(damping=1.0)}.items():
        with Instance(pack(scene, name=name)) as other:
            foreign.append(save(other.initialize()))
    with Instance(pack(swinging_sheet())) as cloth:
        cloth.initialize().run(0.01, 0.005)
        before = ends(cloth)
        own = save(cloth)
        cases = [("another scene", foreign[0]), ("other meshes", foreign[1]), ("bytes; expected", own[:-9]),
                 ("no saved state", b"\x50" * len(own)), ("have changed", own[:400] + b"\x7f" + own[401:])]
        for said, data in cases:
            cloth.log.clear()
            with pytest.raises(FMICallException) as refused:
                cloth.slave.deSerializeFMUstate(data)
            assert refused.value.status == DISCARD
            assert len(cloth.log) == 1 and said in cloth.log[0][2], cloth.log
        assert same_bits(ends(cloth), before)
        cloth.run(0.02, 0.005)
