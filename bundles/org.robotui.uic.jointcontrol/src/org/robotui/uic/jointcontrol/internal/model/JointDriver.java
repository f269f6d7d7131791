package org.robotui.uic.jointcontrol.internal.model;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.robotui.api.command.Authority;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointCommand;

/**
 * Turns what the hands want into references of joints, within lease and stop. Nothing is sent before the user has taken
 * control and answered a question that names what will move; whatever makes driving doubtful ends it, and says why.
 * Hands come from the display thread, ticks from the view's worker: one lock, never held while anything blocks, so that
 * no reference follows the release.
 */
public final class JointDriver {
  /** How long a reference holds. */
  public static final Duration VALID = Duration.ofMillis(200);

  private final Output<JointCommand> output;
  private final Principal principal;
  private final DoubleSupplier speed;
  private final Aims aims = new Aims();
  private Joints joints = Joints.NONE;
  private InputState state = new InputState.Unconnected("no data yet");
  private Phase phase = Phase.MONITOR;
  private boolean sending;
  private Optional<String> told = Optional.empty();

  /** With the share of their speed at which joints move at most, 0 to 1. */
  public JointDriver(Output<JointCommand> output, Principal principal, DoubleSupplier speed) {
    this.output = output;
    this.principal = principal;
    this.speed = speed;
  }

  /** What is measured now. Called from the tick, before {@link #tick}. */
  public synchronized void see(Joints now, InputState inputState) {
    joints = now;
    state = inputState;
  }

  /** The user wants to drive, or does no more. */
  public synchronized void toggle() {
    switch (phase) {
      case DRIVING -> giveBack();
      case ASKING -> cancel();
      case MONITOR -> ask();
    }
  }

  private void ask() {
    told = blocked().map(why -> "Cannot drive: " + why);
    phase = told.isEmpty() ? Phase.ASKING : Phase.MONITOR;
  }

  /** The user does not want to drive after all. */
  public synchronized void cancel() {
    if (phase == Phase.ASKING) {
      phase = Phase.MONITOR;
      told = Optional.empty();
    }
  }

  /**
   * The user has read what will move, and wants that. The holder that the question named may be taken over, nobody
   * else.
   */
  public synchronized void confirm(boolean takeover) {
    if (phase != Phase.ASKING) {
      return;
    }
    Optional<String> obstacle = blocked();
    if (obstacle.isPresent()) {
      end("Cannot drive: " + obstacle.get());
    } else if (authority().take(principal, takeover) instanceof Authority.LeaseOutcome.Granted) {
      phase = Phase.DRIVING;
      told = Optional.empty();
    }
  }

  /** Ends driving and gives control of the robot back. */
  public synchronized void giveBack() {
    halt();
    told = Optional.empty();
    authority().giveBack(principal);
  }

  /** Ends driving, where that is so; what is said is read by the user. */
  public synchronized void end(String why) {
    if (phase != Phase.MONITOR) {
      halt();
      told = Optional.of(why);
    }
  }

  /** Stops the robot. */
  public synchronized void stop() {
    authority().stop(principal);
    end("Joints are not driven any more");
  }

  /** Unlatches the stop; driving must be asked for anew. */
  public synchronized void releaseStop() {
    authority().releaseStop(principal);
    told = Optional.empty();
  }

  /** Whether a joint moves only while a hand holds. */
  public synchronized void jog(boolean wanted) {
    aims.jog(wanted);
  }

  /** Drives a joint toward a position. */
  public synchronized void goal(String joint, double position) {
    begin(joint).ifPresent(seen -> aims.toward(joint, Span.of(seen.model()).within(position)));
  }

  /** Moves the goal of a joint a little. */
  public synchronized void nudge(String joint, double by) {
    begin(joint).ifPresent(seen -> aims.toward(joint, Span.of(seen.model()).within(aims.of(joint).goal() + by)));
  }

  /** No hand holds any more: where joints move only while one does, they stop. */
  public synchronized void letGo() {
    aims.letGo();
  }

  /** Sets how stiffly a joint keeps its position. */
  public synchronized void stiffness(String joint, double value) {
    begin(joint).ifPresent(seen -> aims.change(joint, aim -> aim.stiff(value)));
  }

  /** Sets how much a joint damps its motion. */
  public synchronized void damping(String joint, double value) {
    begin(joint).ifPresent(seen -> aims.change(joint, aim -> aim.damped(value)));
  }

  /** Sends what is due. Called from the tick, at the rate at which references are to be renewed. */
  public synchronized void tick(long now) {
    if (phase == Phase.MONITOR) {
      return;
    }
    String what = phase == Phase.DRIVING ? "Not driving any more: " : "Cannot drive: ";
    blocked().or(this::lost).ifPresent(why -> end(what + why));
    if (phase == Phase.DRIVING) {
      aims.deaf(joints, now).ifPresent(why -> told = Optional.of(why));
      List<JointCommand.Joint> references = aims.step(joints, authority().limits(), speed.getAsDouble(), now);
      if (references.isEmpty()) {
        release();
      } else {
        send(references);
      }
    }
  }

  /** What is to be shown. */
  public synchronized DriveLook look() {
    Authority authority = authority();
    Optional<Principal> holder = authority.holder();
    return new DriveLook(phase, authority.robot(), joints.naming(), aims.all(), aims.isJog(), speed.getAsDouble(),
        holder.filter(h -> !h.equals(principal)).map(Principal::label), holder.filter(principal::equals).isPresent(),
        authority.stoppedBy().map(Principal::label), owners(), blocked(), told);
  }

  private Optional<Joints.Seen> begin(String joint) {
    if (phase != Phase.DRIVING) {
      return Optional.empty();
    }
    Optional<Joints.Seen> seen = joints.find(joint);
    Optional<String> refusal = seen.flatMap(aims::refusal);
    if (seen.isPresent() && refusal.isEmpty()) {
      told = Optional.empty();
      aims.begin(seen.get());
      return seen;
    }
    told = refusal;
    return Optional.empty();
  }

  /** What must be so that joints can be driven at all. */
  private Optional<String> blocked() {
    Optional<Principal> stopper = authority().stoppedBy();
    if (stopper.isPresent()) {
      return Optional.of(authority().robot() + " is stopped by " + stopper.get().label());
    }
    if (!(output.state() instanceof InputState.Live)) {
      return Optional.of(output.state().explanation());
    }
    return switch (state) {
      case InputState.Live live when joints.byName().isEmpty() -> Optional.of("the robot has no joints");
      case InputState.Live live when !joints.described() -> Optional.of("the limits of the joints are not known");
      case InputState.Live live -> Optional.empty();
      case InputState.Stale stale -> Optional.of("the state of the joints is stale");
      default -> Optional.of("the state of the joints is not known");
    };
  }

  private Optional<String> lost() {
    boolean mine = authority().holder().filter(principal::equals).isPresent();
    if (phase != Phase.DRIVING || mine) {
      return Optional.empty();
    }
    return Optional.of(authority().holder().map(h -> h.label() + " took control of " + authority().robot())
        .orElse("control of " + authority().robot() + " was given back"));
  }

  private Optional<String> owners() {
    String named = joints.byName().values().stream().map(seen -> seen.state().owner()).filter(owner -> !owner.isEmpty())
        .distinct().collect(Collectors.joining(", "));
    return named.isEmpty() ? Optional.empty() : Optional.of("Owned now by " + named);
  }

  private void send(List<JointCommand.Joint> references) {
    sending = true;
    if (output.send(new JointCommand(references), VALID) instanceof CommandOutcome.Refused refused) {
      end("Not driving any more: " + refused.explanation());
    }
  }

  private void halt() {
    phase = Phase.MONITOR;
    aims.clear();
    release();
  }

  private void release() {
    if (sending) {
      sending = false;
      output.release();
    }
  }

  private Authority authority() {
    return output.authority();
  }
}
