"""Robots: joints as arrays, places, pushes, levels."""

import gc

import numpy as np
import pytest

import murosimf as ms


def test_arrays_of_joints_are_live(scene: ms.Scene) -> None:
    robot = scene.robot
    q, v = robot.joint_position, robot.joint_velocity
    assert q.shape == v.shape == (len(robot.joints),)
    assert q is robot.joint_position
    joint = "j_l_upper_arm"
    robot.joint_target[joint] = 0.4
    scene.run(0.5)
    assert q[joint] == pytest.approx(0.4, abs=0.05)
    # as the numbers that the library has by name, for every joint
    for name, number in robot.joints.numbers.items():
        assert q[number] == robot[name]["joint_position"][0]
        assert v[number] == robot[name]["joint_velocity"][0]
    robot.joint_position = 0.1 * np.ones(len(q))
    assert robot[joint]["joint_position"][0] == 0.1
    assert np.sin(q).shape == q.shape


def test_arrays_follow_loads_resets_and_levels(scene: ms.Scene) -> None:
    robot = scene.robot
    q, torque = robot.joint_position, robot.joint_torque
    begin, state = q.copy(), scene.save()
    robot.joint_target[:] = begin + 0.2
    scene.run(0.3)
    moved = q.copy()
    assert np.abs(moved - begin).max() > 0.1
    scene.load(state)
    assert (q == begin).all()
    scene.run(0.1)
    robot.level = "simplified_dynamics"
    robot.joint_target[:] = begin + 0.1
    scene.run(0.3)
    assert robot.level == "simplified_dynamics"
    assert (q == [robot[name]["joint_position"][0] for name in robot.joints]).all()
    scene.reset()
    assert (q == begin).all()
    assert torque.shape == q.shape


def test_what_cannot_be_written_is_refused(scene: ms.Scene) -> None:
    robot = scene.robot
    with pytest.raises(ValueError, match="read-only"):
        robot.joint_torque[0] = 1
    with pytest.raises(KeyError, match="^unknown joint 'j_l_shn'; did you mean 'j_l_shin'\\?$"):
        robot.joint_target["j_l_shn"] = 0.4
    before = robot.joint_target.copy()
    robot.joint_target[0] = np.nan
    with pytest.raises(ms.InputError, match="joint_target of 'robot'"):
        scene.step()
    assert (robot.joint_target == before).all()
    walker = ms.Scene("walk", set={"walker.level": "simplified_dynamics"})
    walker.robot.joint_target[0] += 0.1
    with pytest.raises(ms.InputError, match="joint targets of 'walker' are written by .* give it the controller 'none'"):
        walker.step()
    walker.step()
    with pytest.raises(ms.UnknownName, match="only the robot's own array"):
        (2 * robot.joint_position)["j_l_shin"]


def test_memory_outlives_the_scene(scene: ms.Scene) -> None:
    q, imu, places = scene.robot.joint_position, scene.robot.sensors["imu"].values, scene.robot.objects.position
    head = scene.robot["head"]
    expected = q.copy(), places.copy()
    del scene
    gc.collect()
    ballast = [np.full(100_000, 1.0) for _ in range(20)]
    assert (q == expected[0]).all()
    assert (places == expected[1]).all()
    q[0], places[0, 0] = 7, 8
    assert imu.size > 0
    assert head.position.shape == (3,)
    del ballast


def test_many_steps_and_scenes_do_not_leak() -> None:
    def resident() -> int:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    def use() -> None:
        scene = ms.Scene("walk", cameras=False)
        robot = scene.robot
        for _ in range(50):
            scene.step(2)
            robot.objects.orientation[0, 0, 0] += 0
        robot.joint_velocity[:] = 0
        scene.save()

    for _ in range(5):
        use()
    gc.collect()
    before = resident()
    for _ in range(60):
        use()
    gc.collect()
    assert resident() - before < 60 * 50_000  # a scene takes some 280 kB


def test_places_and_views(scene: ms.Scene) -> None:
    robot = scene.robot
    objects = robot.objects
    assert objects.position.shape == (len(objects), 3)
    assert objects.orientation.shape == (len(objects), 3, 3)
    assert objects.view("joint_position").shape == (len(objects),)
    head = objects.names.index("j_head")
    assert (objects.position[head] == robot["head"].position).all()
    w, x, y, z = robot["head"].pose.quaternion
    turned = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]  # x axis of the head
    assert objects.orientation[head, :, 0] == pytest.approx(turned)
    robot.place((1, 2, 0), heading=0.5)
    assert robot.position[:2] == pytest.approx([1, 2], abs=1e-9)
    assert np.arctan2(robot.orientation[1, 0], robot.orientation[0, 0]) == pytest.approx(0.5)
    robot.position = (3, 2, 1)
    assert (robot.position == [3, 2, 1]).all()
    robot.linear_velocity = (0.5, 0, 0)
    assert (robot.linear_velocity == [0.5, 0, 0]).all()
    with pytest.raises(ms.UnknownName, match="unknown object of 'robot' 'haed'"):
        robot["haed"]


def test_pushes_move_a_free_body() -> None:
    scene = ms.Scene.of_text('[[bodies]]\nname = "crate"\nshape = "box"\nsize = [0.2, 0.2, 0.2]\nmass = 3.0\n'
                             "position = [0, 0, 2]\n")
    scene.entity("crate").push(force=(30, 0, 0), duration=0.1)
    scene.run(0.2)
    # momentum: 30 N for 0.1 s
    assert scene.entity("crate").linear_velocity[0] == pytest.approx(30 * 0.1 / 3.0, rel=0.02)


def test_commands_and_motions() -> None:
    scene = ms.Scene("walk")
    walker = scene["walker"]
    walker.command(0.0)
    scene.run(2.0)
    x = walker.position[0]
    walker.command(0.2)
    scene.run(2.0)
    assert walker.position[0] > x + 0.2
    assert walker.falls == 0
    assert not walker.fallen
    with pytest.raises(ms.UnknownName):
        walker.play("no_such_motion")


def test_sensors(scene: ms.Scene) -> None:
    imu = scene.robot.sensors["imu"]
    live = imu["accelerometer"]
    scene.run(0.2)
    assert imu.samples > 0
    assert np.linalg.norm(live) == pytest.approx(9.81, abs=2)
    assert (imu.read()["accelerometer"] == live).all()
    assert imu.units["accelerometer"] == "m/s^2"
    assert "imu" in scene.robot.sensors
    with pytest.raises(ms.UnknownName, match="did you mean 'gyroscope'"):
        imu["gyroscop"]


def test_kinematics_in_the_pose_of_the_scene(scene: ms.Scene) -> None:
    robot = scene.robot
    rng = np.random.default_rng(1)
    k = robot.kinematics
    q = rng.uniform(-0.5, 0.5, (4, len(robot.joints)))
    position, quaternion = k.fk(q, "head")
    assert position.shape == (4, 3)
    assert quaternion.shape == (4, 4)
    # the linear part of the Jacobian is the derivative of the position
    jacobian, step = k.jacobian(q, "head"), 1e-6
    for joint in range(q.shape[1]):
        moved = q.copy()
        moved[:, joint] += step
        slope = (k.fk(moved, "head").position - position) / step
        assert jacobian[:, :3, joint] == pytest.approx(slope, abs=1e-5)
    # torques are linear in accelerations, by the mass matrix (Featherstone 2008, eq. 3.1)
    zero, a = np.zeros_like(q[0]), rng.uniform(-1, 1, q.shape[1])
    inertial = k.rnea(q[0], zero, a) - k.rnea(q[0], zero, zero)
    assert k.mass_matrix(q[0])[6:, 6:] @ a == pytest.approx(inertial, abs=1e-9)
    assert k.mass_matrix(q)[2] == pytest.approx(k.mass_matrix(q[2]))
    assert k.center_of_mass(q[0]).shape == (3,)
    with pytest.raises(ms.InputError, match="q takes"):
        k.fk(q[:, 1:], "head")


def test_pictures(scene: ms.Scene, tmp_path) -> None:  # type: ignore[no-untyped-def]
    try:
        picture = scene.picture(width=160, height=120)
    except ms.InputError as error:
        pytest.skip(str(error))
    assert picture.rgb.shape == (120, 160, 3)
    assert picture.rgb.dtype == np.uint8
    assert picture.rgb.std() > 5
    picture.save(tmp_path / "a.png")
    image = pytest.importorskip("PIL.Image")
    assert (np.asarray(image.open(tmp_path / "a.png")) == picture.rgb).all()
    assert picture.depth is not None
    assert picture.depth.shape == (120, 160)


def test_samples_of_sensors_are_kept(scene: ms.Scene) -> None:
    imu = scene.robot.sensors["imu"]
    with pytest.raises(ms.StateError, match="samples of sensor 'imu' are not kept"):
        assert imu.history is None
    imu.keep(10)
    assert len(imu.history) == 0
    scene.run(0.02)
    first = imu.samples
    assert first > 0
    history = scene.robot.sensors["imu"].history  # of the scene, not of the object that was asked
    assert len(history) == first
    assert history["time"][-1] == imu.time
    assert (history["gyroscope"][-1] == imu["gyroscope"]).all()
    assert (np.diff(history["time"]) > 0).all()
    scene.run(0.1)
    assert len(imu.history) == 10
    state = scene.save()
    scene.reset()
    scene.step(3)
    assert len(imu.history) == imu.samples
    scene.load(state)
    scene.step()
    assert imu.history["time"][-1] == imu.time


def test_arrays_of_robots_that_have_left_show_nothing(scene: ms.Scene) -> None:
    robot = scene.robot
    q, place = robot.joint_position, robot.position.copy()
    begin = q.copy()
    scene.step()
    scene.leave("robot")
    assert np.isnan(q).all() and np.isnan(robot.joint_target).all()
    with pytest.raises(ms.StateError, match="^'robot' has left the scene: enter\\(\\) brings it back$"):
        assert robot.position is None
    robot.joint_target[:] = 0
    with pytest.raises(ms.StateError, match="^'robot' has left the scene"):
        scene.step()
    assert np.isnan(robot.joint_target).all()
    scene.run(0.1)
    scene.enter("robot")
    assert (q == begin).all()
    assert np.abs(robot.position - place).max() < 1e-9
    robot.joint_target[:] = begin
    scene.step()
