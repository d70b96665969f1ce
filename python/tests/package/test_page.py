"""A scene that browsers see and steer between the calls of a script."""

import sys
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import murosimf as ms


@pytest.fixture
def page(scene: ms.Scene) -> Iterator[ms.Page]:
    try:
        page = scene.show(web=True, speed=None)
    except ms.InputError as error:
        if "without a server" not in str(error):
            raise
        pytest.skip(str(error))
    yield page
    page.close()


def visitor(page: ms.Page, root: Path) -> Any:
    """A WebSocket of the page's own protocol (docs/web.md)."""
    sys.path.insert(0, str(root / "tests/web"))
    from client import Client  # type: ignore[import-not-found]

    return Client(int(page.address.rstrip("/").rpartition(":")[2]))


def wait_until(condition: Any) -> None:
    for _ in range(2000):
        if condition():
            return
        time.sleep(0.01)
    raise AssertionError("it did not come")


def test_looking_changes_nothing(scene: ms.Scene, page: ms.Page, root: Path) -> None:
    alone = ms.Scene.of_robot("kid21")
    client = visitor(page, root)
    for each in (scene, alone):
        each.run(0.2)
        each.robot.joint_target["j_l_upper_arm"] = 0.4
        each.robot.push("torso", force=(20, 0, 0), duration=0.05)
        each.run(0.3)
    assert scene.time == 0.5
    assert scene.state_hash == alone.state_hash
    state = scene.save()
    scene.reset(seed=3)
    assert scene.time == 0
    scene.load(state)
    assert scene.state_hash == alone.state_hash
    page.close()
    scene.step(10)
    alone.step(10)
    assert scene.state_hash == alone.state_hash
    client.close()


def test_who_looks_plays_and_changes_between_calls(scene: ms.Scene, page: ms.Page, root: Path) -> None:
    assert page.address in page._repr_html_()
    assert urllib.request.urlopen(page.address).status == 200
    client = visitor(page, root)
    client.send('{"do": "change", "text": "robot.level = simplified_dynamics"}')
    wait_until(lambda: scene.robot.level == "simplified_dynamics")
    assert scene.time == 0
    client.send('{"do": "go_on"}')
    wait_until(lambda: scene.time > 0.05)
    scene.step(2)  # pauses what is played
    paused = scene.nanoseconds
    time.sleep(0.05)
    assert scene.nanoseconds == paused
    client.close()


def test_control_software_fails_where_it_is_played(scene: ms.Scene, page: ms.Page, root: Path) -> None:
    def fails(robot: ms.Robot, now: float) -> None:
        if now > 0.03:
            raise ValueError("enough")

    scene.robot.controller = fails
    client = visitor(page, root)
    client.send('{"do": "go_on"}')
    with pytest.raises(ms.SimulationError, match="the controller of 'robot' failed"):
        wait_until(lambda: scene.time > 1)
    assert scene.time < 0.1  # the script has the scene alone
    client.close()
