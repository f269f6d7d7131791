"""One scene with a robot that runs ROS and one behind a Player server; only the configuration says how they stand to one another."""
import pytest

from conftest import ROOT, wait_for
from desktop import Window, missing

NATALIE = 0x3ecf8e
KEIRA = 0xf5b83d
SCANNED = 150
PATIENCE = 120
WORDS = 700                         # the lists, where their colours also are, end before this column


@pytest.fixture(name="window")
def scene(processes, environment, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    own = environment | {"XDG_STATE_HOME": str(tmp_path / "state")}

    def opened(configuration):
        return Window(processes.start([ROOT / "robotui", "run", "--theme", "dark", str(configuration)], "window", own))
    return opened


def columns(window, colour):
    """Where the scan of a robot is seen, by columns; none while little of it is."""
    places = window.picture().places(colour, WORDS)[0]
    return places.tolist() if len(places) > SCANNED else None


def test_both_are_seen_where_the_configuration_says(window):
    shown = window(ROOT / "configs" / "two-frameworks.yaml")

    natalie = wait_for(lambda: columns(shown, NATALIE), seconds=PATIENCE, what="Natalie's laser")
    keira = wait_for(lambda: columns(shown, KEIRA), seconds=PATIENCE, what="Keira's laser")

    assert max(keira) < min(natalie), "Keira's building stands to the left of Natalie's"


def test_the_other_one_is_not_seen_without_a_configured_edge(window, tmp_path):
    text = (ROOT / "configs" / "two-frameworks.yaml").read_text()
    edge = "          - {parent: Natalie/map, child: Keira/map, x: 0, y: 12}\n"
    assert edge in text
    apart = tmp_path / "apart.yaml"
    apart.write_text(text.replace(edge, "").replace("        frames:  ", "        # frames:"))
    shown = window(apart)

    wait_for(lambda: columns(shown, NATALIE), seconds=PATIENCE, what="Natalie's laser")

    with pytest.raises(AssertionError):
        wait_for(lambda: columns(shown, KEIRA), seconds=10, what="Keira's laser")
