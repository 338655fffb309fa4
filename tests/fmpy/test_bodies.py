"""Bodies through the packed FMU: its contents, its inputs, its outputs."""
import zipfile

import numpy as np
import pytest
from bodies import sheet_over_ball
from fmpy.validation import validate_fmu
from master import Instance, same_bits
from scenes import read_csv, swinging_sheet

CONTACT = {"libdrape_contact.so"}


def libraries(fmu):
    return {n.split("/")[-1] for n in zipfile.ZipFile(fmu.file).namelist() if n.startswith("binaries/linux64/") and n[-1] != "/"}


def test_the_contact_library_is_packed_where_there_is_a_body(pack, tmp_path):
    with_body = pack(sheet_over_ball(tmp_path), name="with")
    assert libraries(with_body) == CONTACT | {with_body.library.name}
    assert validate_fmu(str(with_body.file)) == []
    assert not CONTACT & libraries(pack(swinging_sheet(), name="without"))


def test_the_guid_covers_the_meshes(pack, tmp_path):
    """An FMU whose mesh has been exchanged for another is refused."""
    fmu = pack(sheet_over_ball(tmp_path))
    mesh = next((fmu.folder / "resources").glob("body_*.obj"))
    mesh.write_text(mesh.read_text() + "# another\n")
    log = []
    with pytest.raises(Exception, match="instantiate"):
        Instance(fmu, log=log)
    assert any("the guid is" in message for _, _, message in log)


def test_is_the_run_of_the_command(pack, drape, write, tmp_path):
    scene = sheet_over_ball(tmp_path)
    drape("run", write(scene, "run"), "-o", tmp_path / "out", "--until", 0.05, "--every", 0.05)
    columns, rows = read_csv(tmp_path / "out" / "outputs.csv")
    there = dict(zip(columns, rows[-1]))
    fmu = pack(scene)
    (tmp_path / "ball.obj").unlink()  # the FMU contains it
    with Instance(fmu) as cloth:
        cloth.initialize().run(0.05, 0.005)
        names = ["strain.warp.max", "contact.count", "contact.penetration.max", "contact.pressure.max", "step.count"]
        assert same_bits(cloth.get(*names), [there[n] for n in names])
        assert cloth.get("contact.count")[0] > 0


def test_momentum_is_balanced_with_a_ball_that_moves(pack, tmp_path):
    """Over every step of the master: what the cloth gains is its weight's impulse less that on the ball."""
    fmu = pack(sheet_over_ball(tmp_path, moves=True), nodes="all")
    with Instance(fmu) as cloth:
        cloth.initialize()
        count = len(cloth.nodes())
        area = np.full((11, 11), 1e-4)
        area[[0, -1], :] /= 2
        area[:, [0, -1]] /= 2
        mass = 0.15 * area.reshape(count, 1)
        before = (mass * cloth.nodes("velocity")).sum(0)
        most = 0
        for k in range(1, 41):
            t = k * 1e-3
            lift = {"position": [0, 0, 0.01 * np.sin(40 * t)], "velocity": [0, 0, 0.4 * np.cos(40 * t)]}
            cloth.drive({f"body.ball.{name}": value for name, value in lift.items()})
            cloth.step(1e-3)
            after = (mass * cloth.nodes("velocity")).sum(0)
            told = 1e-3 * cloth.get(*(f"body.ball.force[{i}]" for i in (1, 2, 3)))
            weight = np.array([0, 0, -9.81e-3 * mass.sum()])
            assert np.abs(after - before - weight + told).max() < 1e-9 * max(most := max(most, np.abs(told).max()), 1e-6)
            before = after
        assert most > 1e-5


def test_friction_is_tuned_while_it_moves(pack, tmp_path):
    """Without friction the sheet slides off the ball; with it, it stays."""
    fmu = pack(sheet_over_ball(tmp_path, damping=5.0), nodes="all")

    def middle(friction):
        with Instance(fmu) as cloth:
            cloth.initialize().run(0.05, 0.01)
            cloth.set("fabric.wool.friction", friction)
            cloth.run(0.25, 0.01)
            return cloth.nodes().mean(0)

    slides, stays = middle(0.0), middle(1.5)
    assert slides[0] > stays[0] + 0.001


def test_an_orientation_of_zeros_keeps_the_old_one(pack, tmp_path):
    """Some masters write 0 to what is not connected."""
    fmu = pack(sheet_over_ball(tmp_path, moves=True), nodes="all")
    with Instance(fmu) as cloth, Instance(fmu) as connected:
        for each in (cloth, connected):
            each.initialize().drive({"body.ball.orientation": [1, 0, 0, 1]})
            assert each.step(1e-3) == 0
        cloth.log.clear(), connected.log.clear()
        for _ in range(3):  # told once
            cloth.drive({"body.ball.orientation": [0, 0, 0, 0]})
            assert cloth.step(1e-3) == 0  # FMPy passes a warning on by its log alone
            assert connected.step(1e-3) == 0
        assert same_bits(cloth.nodes(), connected.nodes())
        told = [message for log in (cloth.log, connected.log) for _, category, message in log if category == "logStatusWarning"]
        assert told == ["body.ball.orientation is four zeros, and no rotation: the orientation stays as it is"]
