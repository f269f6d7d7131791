package org.robotui.uic.team.internal.model;

import java.util.Optional;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.navigation.Odometry;
import org.robotui.ui.Figures;
import org.robotui.ui.LinkLook;

/**
 * What a robot is doing, and why that is known.
 *
 * @param doing what it is doing
 * @param words the same in words
 * @param why a sentence, may be empty
 */
record Condition(Activity doing, String words, String why) {
  private static final String STOPPED = "stopped";

  static Condition of(Member member, Input<Odometry> odometry, Optional<Boolean> moving, Optional<String> stopper) {
    Condition seen = seen(member, odometry, moving);
    boolean live =
        seen.doing() == Activity.DRIVING || seen.doing() == Activity.STANDING || seen.doing() == Activity.WAITING;
    if (stopper.isEmpty()) {
      return seen;
    }
    String by = "stopped by " + stopper.get() + "; it moves only after the stop was released";
    return live
        ? new Condition(Activity.STOPPED, moving.orElse(false) ? STOPPED + ", still moving" : STOPPED, by)
        : new Condition(seen.doing(), STOPPED + ", " + seen.words(), by + ". " + seen.why());
  }

  private static Condition seen(Member member, Input<Odometry> odometry, Optional<Boolean> moving) {
    if (member.isLost()) {
      return new Condition(Activity.LOST, "no link", LinkLook.text(member.worst()));
    }
    Optional<SourceId> source = odometry.sources().stream().filter(member::has).findFirst();
    InputState state = source.map(odometry::state).orElseGet(() -> new InputState.Waiting("it offers no odometry"));
    return switch (state) {
      case InputState.Failed f -> new Condition(Activity.SILENT, "silent", f.explanation());
      case InputState.Stale s when s.lostSeconds().isPresent() -> new Condition(Activity.SILENT, "silent",
          s.explanation());
      case InputState.Stale s -> new Condition(Activity.STALE, "stale " + Figures.age(s.ageSeconds()), s.explanation());
      case InputState.Waiting w -> new Condition(Activity.WAITING, "no position", w.explanation());
      case InputState.Unconnected u -> new Condition(Activity.WAITING, "no position", u.explanation());
      case InputState.Live l -> moving.orElse(false)
          ? new Condition(Activity.DRIVING, Activity.DRIVING.word(), "")
          : new Condition(Activity.STANDING, Activity.STANDING.word(), "");
    };
  }
}
