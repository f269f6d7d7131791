package org.robotui.rfic.xbot.internal.follow;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.ActionReply.End;
import org.robotui.api.port.ActionRequest;
import org.robotui.api.port.CallHandler.Invocation;
import org.robotui.xbot.Answer;

/** A goal that a plugin is told, until it ends. For one thread, which is interrupted where the goal is cancelled. */
final class FollowedGoal {
  private static final Duration TURN = Duration.ofMillis(20);
  private static final long FEEDBACK = Duration.ofMillis(50).toNanos();
  /** Until a plugin has checked what it was told. */
  private static final long TO_BEGIN = Duration.ofSeconds(5).toNanos();
  /** Of a plugin that runs. */
  private static final long SILENCE = Duration.ofSeconds(2).toNanos();

  private final FollowLink link;
  private final String plugin;
  private final long tag;
  private final FollowFeedback feedback;
  private final Invocation<ActionRequest> told;
  private Optional<FollowReport> report = Optional.empty();
  private boolean begun;
  private boolean cancelled;
  private long toldAt;
  private long newsAt;
  private long fedAt;

  FollowedGoal(FollowLink link, String plugin, long tag, FollowFeedback feedback, Invocation<ActionRequest> told) {
    this.link = link;
    this.plugin = plugin;
    this.tag = tag;
    this.feedback = feedback;
    this.told = told;
  }

  /** Tells it, and waits for its end. */
  ActionReply follow(List<String> orders) {
    toldAt = System.nanoTime();
    fedAt = toldAt - FEEDBACK;
    Optional<ActionReply> refused = tell(orders);
    while (refused.isEmpty()) {
      look();
      Optional<ActionReply> end = begun ? ended() : refusedOrBegun();
      if (end.isPresent()) {
        return end.get();
      }
      rest();
    }
    return refused.get();
  }

  /** What the plugin says of an order that it refuses stands in its report. */
  private Optional<ActionReply> tell(List<String> orders) {
    for (String order : orders) {
      Answer answer = command(order);
      if (!answer.ok()) {
        return Optional.of(refusal(answer.text()));
      }
    }
    return Optional.empty();
  }

  private ActionReply refusal(String otherwise) {
    long until = System.nanoTime() + SILENCE;
    do {
      look();
      Optional<FollowReport> said = report.filter(r -> r.told() == tag && r.isRefused());
      if (said.isPresent()) {
        return codeOf(said.get()).rejected(said.get().refusal());
      }
      rest();
    } while (!cancelled && System.nanoTime() < until);
    return FollowCode.INVALID_GOAL.rejected(otherwise);
  }

  private static FollowCode codeOf(FollowReport refused) {
    return refused.toldPhase() == FollowReport.Phase.BAD_JOINTS ? FollowCode.INVALID_JOINTS
        : FollowCode.INVALID_GOAL;
  }

  private Answer command(String order) {
    return link.ask("command " + plugin + " " + order);
  }

  private void look() {
    Answer answer = link.ask("trajectory " + plugin);
    Optional<FollowReport> next = answer.ok() ? FollowReport.read(answer.text()) : Optional.empty();
    if (next.isPresent() && !next.map(FollowReport::seconds).equals(report.map(FollowReport::seconds))) {
      newsAt = System.nanoTime();
    }
    report = next.or(() -> report);
  }

  private Optional<ActionReply> refusedOrBegun() {
    if (report.isPresent() && report.get().followed() == tag) {
      begun = true;
      newsAt = System.nanoTime();
      told.progress(Double.NaN, "executing");
      return ended();
    }
    if (report.isPresent() && report.get().told() != tag) {
      return Optional.of(FollowCode.INVALID_GOAL.rejected("another client told " + plugin + " another trajectory"));
    }
    if (report.isPresent() && report.get().isRefused()) {
      String why = report.get().refusal();
      return Optional.of(cancelled ? FollowCode.SUCCESSFUL.end(End.RECALLED, why)
          : codeOf(report.get()).rejected(why));
    }
    if (System.nanoTime() - toldAt > TO_BEGIN) {
      stop();
      return Optional.of(FollowCode.INVALID_GOAL.rejected(plugin + " did not begin it in time"));
    }
    return Optional.empty();
  }

  private Optional<ActionReply> ended() {
    FollowReport now = report.orElseThrow();
    if (now.followed() != tag) {
      return Optional.of(FollowCode.SUCCESSFUL.end(End.PREEMPTED, "another trajectory took over"));
    }
    return switch (now.phase()) {
      case DONE -> Optional.of(FollowCode.SUCCESSFUL.end(End.SUCCEEDED, ""));
      case OFF_PATH -> Optional.of(FollowCode.PATH_TOLERANCE_VIOLATED.end(End.ABORTED, now.ending()));
      case OFF_GOAL -> Optional.of(FollowCode.GOAL_TOLERANCE_VIOLATED.end(End.ABORTED, now.ending()));
      case STOPPED -> Optional.of(cancelled ? FollowCode.SUCCESSFUL.end(End.PREEMPTED, "cancelled")
          : FollowCode.PATH_TOLERANCE_VIOLATED.end(End.ABORTED, now.ending()));
      default -> goesOn(now);
    };
  }

  private Optional<ActionReply> goesOn(FollowReport now) {
    long time = System.nanoTime();
    if (time - newsAt > SILENCE) {
      return Optional.of(FollowCode.PATH_TOLERANCE_VIOLATED.end(End.ABORTED,
          plugin + " is " + link.ask("status " + plugin).text()));
    }
    if (time - fedAt >= FEEDBACK) {
      fedAt = time;
      link.state().flatMap(state -> feedback.of(now, state, System.currentTimeMillis() * 1_000_000L))
          .ifPresent(told::feedback);
    }
    return Optional.empty();
  }

  private void rest() {
    try {
      Thread.sleep(TURN);
    } catch (InterruptedException e) {
      cancel();
    }
  }

  /** The joints come to rest, and hold: how that ends is awaited, as long as the caller does. */
  private void cancel() {
    cancelled = true;
    stop();
  }

  private void stop() {
    command("@" + tag + " stop");
  }
}
