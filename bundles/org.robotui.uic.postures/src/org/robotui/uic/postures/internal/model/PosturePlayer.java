package org.robotui.uic.postures.internal.model;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;
import org.robotui.api.command.Authority;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.ControlPlugins;
import org.robotui.ui.Health;

/**
 * Has the robot go through postures, one after the other: each way is a trajectory of its own, which the plugin of the
 * control checks, and at whose end it holds. Whatever makes that doubtful ends it, and says why; nothing goes on by
 * itself. All threads: one lock, never held while anything blocks.
 */
final class PosturePlayer {
  private static final Duration PATIENCE = Duration.ofSeconds(5);
  private static final long TO_SAY_NANOS = 1_000_000_000L;
  private static final long HELD_UP_NANOS = 200_000_000L;
  private static final long LONGEST_HELD_UP_NANOS = 3_000_000_000L;
  private static final long UNSEEN_NANOS = 3_000_000_000L;

  /** What the user wants of it. */
  record Wishes(String plugin, String guide, DoubleSupplier speed, BooleanSupplier loop) {}

  private enum Step {
    /** The control is told. */
    TELLING,
    /** The robot moves. */
    MOVING,
    /** Something was not done: why is awaited. */
    ASKING_WHY,
    /** It was not let through: it is said again in a moment. */
    HELD_UP
  }

  private final Caller<PluginRequest, PluginReply> caller;
  private final Wishes wishes;
  private List<Posture> postures = List.of();
  private int index;
  private Optional<Step> step = Optional.empty();
  private final Deque<PluginRequest> requests = new ArrayDeque<>();
  private RobotNow now = RobotNow.of(new InputState.Unconnected("no data yet"), Optional.empty(),
      Optional.empty());
  private long nowNanos;
  private long saidNanos;
  private long begunNanos;
  private String statusBefore = "";
  private String reply = "";
  /** Whether the plugin was seen to run: what it said before it was started comes for a while. */
  private boolean ran;
  private long run;
  private Optional<Posture> failed = Optional.empty();
  private Health health = Health.NONE;
  private String words = "";

  PosturePlayer(Caller<PluginRequest, PluginReply> caller, Wishes wishes) {
    this.caller = caller;
    this.wishes = wishes;
  }

  boolean isConnected() {
    return !caller.targets().isEmpty();
  }

  /** Begins with a posture of some, once the user has control of the robot. */
  synchronized void play(List<Posture> all, int from) {
    if (from >= all.size()) {
      return;
    }
    postures = List.copyOf(all);
    index = from;
    failed = Optional.empty();
    ran = now.isRunning(wishes.plugin());
    requests.clear();
    if (now.isRunning(wishes.guide())) {
      requests.add(new PluginRequest(wishes.guide(), Verb.STOP, ""));
    }
    if (!now.isRunning(wishes.plugin())) {
      requests.add(new PluginRequest(wishes.plugin(), Verb.START, ""));
    }
    leg();
  }

  /** The user wants it to end: the joints come to rest where they are. */
  synchronized void stop() {
    if (step.isPresent()) {
      Posture target = postures.get(index);
      ended(Health.WARNING, "Stopped on the way to " + target.name());
      caller.call(new PluginRequest(wishes.plugin(), Verb.COMMAND, "stop"), PATIENCE, Caller.Progress.IGNORED);
    }
  }

  /** Lets joints be moved by hand, or no more. */
  synchronized void guide(boolean wanted) {
    stop();
    run++;
    requests.clear();
    if (wanted && now.isRunning(wishes.plugin())) {
      requests.add(new PluginRequest(wishes.plugin(), Verb.STOP, ""));
    }
    requests.add(new PluginRequest(wishes.guide(), wanted ? Verb.START : Verb.STOP, ""));
    say(Health.NONE, wanted ? "Move the joints by hand and store what they reach" : "");
    next(run);
  }

  /** Says something that concerns no posture. */
  synchronized void say(Health dot, String text) {
    health = dot;
    words = text;
  }

  synchronized PlayerLook look() {
    Optional<Posture> target = step.map(s -> postures.get(index));
    return new PlayerLook(target, failed, health, words);
  }

  /** Goes on where that is due. */
  synchronized void tick(RobotNow seen, Optional<Authority> authority, boolean mine, long nanos) {
    boolean unseen = nowNanos != 0 && nanos - nowNanos > UNSEEN_NANOS;
    now = seen;
    nowNanos = nanos;
    ran |= now.isRunning(wishes.plugin());
    if (step.isEmpty()) {
      return;
    }
    Optional<String> obstacle = unseen ? Optional.of("the view was not shown") : obstacle(authority, mine);
    if (obstacle.isPresent()) {
      fail(obstacle.get());
    } else if (step.get() == Step.MOVING) {
      follow();
    } else if (step.get() == Step.ASKING_WHY && nanos - saidNanos > TO_SAY_NANOS) {
      fail(status().filter(s -> s.startsWith("refused")).orElse(reply));
    } else if (step.get() == Step.HELD_UP && nanos - begunNanos > LONGEST_HELD_UP_NANOS) {
      fail(reply);
    } else if (step.get() == Step.HELD_UP && nanos - saidNanos > HELD_UP_NANOS) {
      tell();
    }
  }

  private Optional<String> obstacle(Optional<Authority> authority, boolean mine) {
    Optional<String> stopped = authority.flatMap(Authority::stoppedBy).map(by -> "stopped by " + by.label());
    Optional<String> lost = mine ? Optional.empty()
        : Optional.of(authority.flatMap(Authority::holder).map(h -> h.label() + " has control now")
            .orElse("control was released"));
    Optional<String> blind = now.isLive() ? Optional.empty() : Optional.of("the state of the joints is not known");
    boolean isDue = step.get() == Step.MOVING && (ran || nowNanos - saidNanos > TO_SAY_NANOS);
    Optional<String> gone = !isDue || now.isRunning(wishes.plugin()) ? Optional.empty()
        : Optional.of(wishes.plugin() + " does not run any more"
            + now.plugin(wishes.plugin()).map(ControlPlugins.Plugin::error).filter(e -> !e.isBlank()).map(e -> ": " + e)
                .orElse(""));
    return Stream.of(stopped, lost, blind, gone).flatMap(Optional::stream).findFirst();
  }

  /** What the plugin says may be from before it was told: then it counts only when it stays so. */
  private void follow() {
    String status = status().orElse("");
    boolean isNew = !status.equals(statusBefore) || nowNanos - saidNanos > TO_SAY_NANOS;
    if (isNew) {
      statusBefore = "";
    }
    Posture target = postures.get(index);
    if (status.equals("done") && now.isToldToBeAt(target)) {
      arrived();
    } else if (isNew && (status.startsWith("refused") || status.startsWith("aborted") || status.equals("stopped"))) {
      fail(status);
    }
  }

  private Optional<String> status() {
    return now.plugin(wishes.plugin()).map(ControlPlugins.Plugin::status);
  }

  private void arrived() {
    if (index + 1 < postures.size()) {
      index++;
      leg();
    } else if (wishes.loop().getAsBoolean() && postures.size() > 1) {
      index = 0;
      leg();
    } else {
      ended(Health.OK, postures.size() == 1 ? "At " + postures.getLast().name() : "All postures were gone through");
    }
  }

  private void leg() {
    begunNanos = nowNanos;
    tell();
  }

  private void tell() {
    Posture target = postures.get(index);
    run++;
    step = Optional.of(Step.TELLING);
    LegOrders
        .of(System.nanoTime() & Long.MAX_VALUE | 1, target.joints(), target.seconds(), wishes.speed().getAsDouble())
        .forEach(order -> requests.add(new PluginRequest(wishes.plugin(), Verb.COMMAND, order)));
    say(Health.WAITING, "On the way to " + target.name()
        + (postures.size() > 1 ? ", " + (index + 1) + " of " + postures.size() : ""));
    next(run);
  }

  private void next(long of) {
    PluginRequest request = requests.poll();
    if (request == null) {
      if (step.isPresent()) {
        step = Optional.of(Step.MOVING);
        saidNanos = nowNanos;
      }
      return;
    }
    if (request.verb() == Verb.COMMAND) {
      statusBefore = status().orElse("");
    }
    caller.call(request, PATIENCE, Caller.Progress.IGNORED).outcome()
        .thenAccept(outcome -> answered(request, outcome, of));
  }

  private synchronized void answered(PluginRequest request, CallOutcome<PluginReply> outcome, long of) {
    if (of != run) {
      return;
    }
    Optional<String> why = switch (outcome) {
      case CallOutcome.Replied<PluginReply> replied when replied.reply().done() -> Optional.empty();
      case CallOutcome.Replied<PluginReply> replied -> Optional.of(replied.reply().text());
      case CallOutcome.Failed<PluginReply> not -> Optional.of(not.reason());
      case CallOutcome.TimedOut<PluginReply> late -> Optional.of("the control did not answer in time");
      case CallOutcome.Cancelled<PluginReply> gone -> Optional.of("it was cancelled");
    };
    if (why.isEmpty()) {
      next(of);
    } else if (step.isEmpty()) {
      requests.clear();
      say(Health.BAD, request.plugin() + ": " + why.get());
    } else if (request.verb() == Verb.COMMAND) {
      requests.clear();
      reply = why.get();
      saidNanos = nowNanos;
      // Core lets nothing through while the user could not stop it: while the window is busy, for example.
      step = Optional.of(outcome instanceof CallOutcome.Failed ? Step.HELD_UP : Step.ASKING_WHY);
    } else {
      fail(request.plugin() + ": " + why.get());
    }
  }

  private void fail(String why) {
    Posture target = postures.get(index);
    ended(Health.BAD, target.name() + " was not reached: " + why);
    failed = Optional.of(target);
  }

  private void ended(Health dot, String text) {
    run++;
    requests.clear();
    step = Optional.empty();
    say(dot, text);
  }
}
