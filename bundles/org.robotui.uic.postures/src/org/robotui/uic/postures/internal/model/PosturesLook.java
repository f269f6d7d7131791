package org.robotui.uic.postures.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.ask.ControlFirst;

/**
 * All that the view shows, at one moment.
 *
 * @param state of what is measured
 * @param lines the postures
 * @param playing whether the robot goes through them
 * @param blocked why it cannot
 * @param guiding whether joints are moved by hand; none where the control has no plugin for that
 * @param loop whether the first one follows the last one
 * @param speed share of the greatest speed
 * @param health what to think of the words
 * @param words what is said below
 * @param question what the user is asked before control is taken
 */
public record PosturesLook(InputState state, List<PostureLine> lines, boolean playing, Optional<String> blocked,
    Optional<Boolean> guiding, boolean loop, double speed, Health health, String words,
    Optional<ControlFirst.Question> question) {
  /** Copies the list. */
  public PosturesLook {
    lines = List.copyOf(lines);
  }

  /** Whether the present posture can be stored. */
  public boolean storable() {
    return state instanceof InputState.Live;
  }

  /** What stands at the right of the view's title. */
  public String note() {
    int count = lines.size();
    return (count == 0 ? "" : count == 1 ? "1 posture" : count + " postures") + (playing ? " \u00b7 running" : "");
  }
}
