package org.robotui.uic.jointcontrol.internal.model;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;

/** Where the joints are driven that the user has touched, over time: pure, not safe for several threads. */
final class Aims {
  /** A target that the control does not take over within this time is not heard. */
  static final long DEAF_NANOS = 1_000_000_000L;

  private static final double LONGEST_STEP_SECONDS = 0.1;
  private static final double FIRST_STEP_SECONDS = 0.05;
  private static final double SECONDS_PER_NANO = 1e-9;
  private static final double UNKNOWN_TURNING = 0.5;
  private static final double UNKNOWN_SLIDING = 0.1;
  private static final double HEARD = 1e-3;
  private static final double BEHIND_SECONDS = 0.25;

  private final Map<String, Aim> aims = new LinkedHashMap<>();
  private final Map<String, Long> unheardSince = new LinkedHashMap<>();
  private boolean jog;
  private double share;
  private Optional<Long> lastStep = Optional.empty();

  Map<String, Aim> all() {
    return Map.copyOf(aims);
  }

  Aim of(String joint) {
    return aims.get(joint);
  }

  boolean isJog() {
    return jog;
  }

  void jog(boolean wanted) {
    jog = wanted;
    aims.replaceAll((joint, aim) -> aim.halted());
  }

  void clear() {
    aims.clear();
    unheardSince.clear();
    lastStep = Optional.empty();
  }

  /** Why a joint cannot be driven now. */
  Optional<String> refusal(Joints.Seen seen) {
    String name = seen.model().name();
    if (Double.isNaN(seen.state().measured().position())) {
      return Optional.of(name + " cannot be driven: its position is not measured");
    }
    return seen.state().source() == JointControl.Source.SAFE
        ? Optional.of(name + " cannot be driven: it is in its safe state until its plugin is started again")
        : Optional.empty();
  }

  void begin(Joints.Seen seen) {
    aims.computeIfAbsent(seen.model().name(),
        name -> Aim.from(Span.of(seen.model()).within(seen.state().measured().position())));
  }

  void toward(String joint, double position) {
    change(joint, aim -> aim.toward(position));
  }

  void change(String joint, UnaryOperator<Aim> changed) {
    aims.computeIfPresent(joint, (name, aim) -> changed.apply(aim));
  }

  void letGo() {
    if (jog) {
      aims.replaceAll((joint, aim) -> aim.halted());
    }
  }

  /**
   * Gives up joints that went away, fell into their safe state, or do not take over what they are told: one that began
   * to listen after the user has turned to something else would move when nobody expects it.
   */
  Optional<String> deaf(Joints joints, long now) {
    Optional<String> told = Optional.empty();
    for (String name : List.copyOf(aims.keySet())) {
      Optional<String> why = joints.find(name).map(seen -> deaf(seen, now))
          .orElse(Optional.of(name + " is not driven any more: it is gone"));
      if (why.isPresent()) {
        aims.remove(name);
        unheardSince.remove(name);
        told = why;
      }
    }
    return told;
  }

  private Optional<String> deaf(Joints.Seen seen, long now) {
    String name = seen.model().name();
    if (seen.state().source() == JointControl.Source.SAFE) {
      return Optional.of(name + " is not driven any more: it fell into its safe state");
    }
    if (isHeard(seen)) {
      unheardSince.remove(name);
      return Optional.empty();
    }
    long since = unheardSince.computeIfAbsent(name, n -> now);
    String owner = seen.state().owner();
    return now - since < DEAF_NANOS ? Optional.empty()
        : Optional.of(name + " does not take commands: "
            + (owner.isEmpty() ? "no plugin owns it; start the one for communication" : owner + " owns it"));
  }

  /**
   * The state is a little older than what was sent, so that the reference may lie behind on a moving target, but not
   * stay there.
   */
  private boolean isHeard(Joints.Seen seen) {
    boolean commanded =
        seen.state().source() == JointControl.Source.COMMANDED && seen.state().modes().contains(JointMode.POSITION);
    Aim aim = aims.get(seen.model().name());
    double near = Math.max(HEARD, BEHIND_SECONDS * speed(seen.model(), MotionLimits.NONE, share));
    return commanded && Math.abs(seen.state().reference().position() - aim.target()) <= near;
  }

  /** Moves all targets on, and says what is to be sent. */
  List<JointCommand.Joint> step(Joints joints, MotionLimits limits, double most, long now) {
    share = most;
    double seconds = lastStep.map(last -> (now - last) * SECONDS_PER_NANO).orElse(FIRST_STEP_SECONDS);
    lastStep = Optional.of(now);
    List<JointCommand.Joint> references = new ArrayList<>();
    aims.replaceAll((name, aim) -> joints.find(name).map(seen -> {
      Aim next = aim.step(speed(seen.model(), limits, share) * Math.clamp(seconds, 0.0, LONGEST_STEP_SECONDS));
      references.add(reference(name, next, seen.state()));
      return next;
    }).orElse(aim));
    return references;
  }

  /** How fast the target of a joint moves at most, radians or metres per second. */
  static double speed(JointModel.Joint joint, MotionLimits limits, double share) {
    boolean slides = joint.type() == JointModel.Type.PRISMATIC;
    boolean known = Double.isFinite(joint.velocity()) && joint.velocity() > 0;
    double most = known ? joint.velocity() : slides ? UNKNOWN_SLIDING : UNKNOWN_TURNING;
    return Math.min(most * share, slides ? limits.linear() : limits.angular());
  }

  private static JointCommand.Joint reference(String name, Aim aim, JointControl.Joint state) {
    Set<JointMode> modes = EnumSet.of(JointMode.POSITION);
    if (aim.stiffness().isPresent() && state.modes().contains(JointMode.STIFFNESS)) {
      modes.add(JointMode.STIFFNESS);
    }
    if (aim.damping().isPresent() && state.modes().contains(JointMode.DAMPING)) {
      modes.add(JointMode.DAMPING);
    }
    return new JointCommand.Joint(name,
        new JointControl.Reference(aim.target(), 0, 0, aim.stiffness().orElse(0), aim.damping().orElse(0)), modes);
  }
}
