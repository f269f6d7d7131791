package org.robotui.script.internal.action;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptLine;
import org.robotui.data.command.VelocityCommand;

/** One motion of a robot from its begin to its end: which velocities, and for how long each. One thread. */
final class MotionTrack {
  /** What a hand at a stick does not notice, in m/s and rad/s. */
  private static final double ALIKE = 0.02;

  /** Velocities in m/s and rad/s. */
  private record Step(double forward, double turn, double left, double seconds) {
    boolean isLike(VelocityCommand velocity) {
      return Math.abs(forward - velocity.linear().x()) < ALIKE && Math.abs(turn - velocity.angular().z()) < ALIKE
          && Math.abs(left - velocity.linear().y()) < ALIKE;
    }

    String words() {
      List<Double> all = left == 0 ? List.of(round(forward), round(turn), round(seconds))
          : List.of(round(forward), round(turn), round(seconds), round(left));
      return ScriptLine.literal(all);
    }

    private static double round(double value) {
      return Math.rint(value * 1000) / 1000;
    }
  }

  private final List<Step> steps = new ArrayList<>();
  private long since;

  MotionTrack(VelocityCommand velocity, long now) {
    begin(velocity, now);
  }

  private void begin(VelocityCommand velocity, long now) {
    steps.add(new Step(velocity.linear().x(), velocity.angular().z(), velocity.linear().y(), 0));
    since = now;
  }

  /** What is commanded from now on; until now it was what was told before. */
  void next(VelocityCommand velocity, long now) {
    until(now);
    if (!steps.getLast().isLike(velocity)) {
      begin(velocity, now);
    }
  }

  /** It goes on as before until now. */
  void until(long now) {
    Step last = steps.removeLast();
    steps.add(new Step(last.forward(), last.turn(), last.left(), last.seconds() + (now - since) * 1e-9));
    since = now;
  }

  double seconds() {
    return steps.stream().mapToDouble(Step::seconds).sum();
  }

  String line(SourceId port, String ruic) {
    return steps.stream().map(Step::words).collect(Collectors.joining(", ", "driveAlong([",
        "], " + ScriptLine.literal(port) + ", " + ScriptLine.literal(ruic) + ");"));
  }
}
