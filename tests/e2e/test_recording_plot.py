"""A plot of a recording shows the whole of it, also what was not played yet, and moves the timeline."""
import pytest

from conftest import SHARED, Robot, wait_for
from desktop import DARK, NAVIGATOR, Window, missing
from playback import CLOSE, RECORDING, Bar

CONFIG = f"""ruics:
  Run:
    type: single
    view: plot
    rfics:
      base: {{type: recording, file: "{RECORDING}", play: false}}
    uics:
      plot:
        legend: top
        axes:
          - traces: [{{signal: "base.odom:pose.translation.y", colour: orange}}]
"""
ORANGE = 0xe0a93b
LEGEND = 110                                        # the top of the window, the title of the view and its legend


@pytest.fixture
def nobody(processes, environment):
    """Nobody to be reached."""
    if not RECORDING.exists():
        pytest.skip("the shared recordings are not here")
    return Robot(processes, "http://127.0.0.1:1", environment)


def line(window, bar):
    """The columns from the first to the last point of the trace."""
    columns, _ = window.picture().places(ORANGE, NAVIGATOR, LEGEND, None, bar.top - 30)
    return (int(columns.min()), int(columns.max())) if len(columns) > 300 else None


def position(window, bar):
    """The column of the timeline's position in the plot: bright from the top to the bottom."""
    columns, _ = window.picture().places(DARK["text"], NAVIGATOR, LEGEND + 60, None, bar.top - 60)
    counts = {column: (columns == column).sum() for column in set(columns.tolist())}
    return max((c for c in counts if counts[c] > 100), default=None)


def test_the_whole_recording_is_plotted_and_a_click_goes_there(nobody, tmp_path):
    if missing():
        pytest.skip(f"tests in a window need {missing()}")
    config = tmp_path / "plot.yaml"
    config.write_text(CONFIG, encoding="utf-8")
    window = Window.open(nobody, config)
    bar = Bar(window)
    wait_for(lambda: bar.is_at(0), what="the recording, standing at its start")
    left, right = wait_for(lambda: line(window, bar), what="the whole trace, of which nothing was played")
    assert right - left > 0.6 * (window.picture().width - NAVIGATOR), (left, right)

    window.click((left + (right - left) * 6 // 10, LEGEND + 200))
    wait_for(lambda: abs((bar.position() or 0) - bar.at(0.6)[0]) < 4 * CLOSE, what="the timeline to go where the plot was clicked")

    window.click(bar.at(0.25))
    window.move(bar.at(0.3))
    wait_for(lambda: abs((position(window, bar) or 0) - (left + (right - left) * 0.25)) < 4 * CLOSE,
             what="the position of the timeline in the plot")
    # The position, which lay over the first point, has gone from it.
    stays = line(window, bar)
    assert stays and abs(stays[0] - left) <= CLOSE and abs(stays[1] - right) <= CLOSE, "a plot stays while the timeline moves"
