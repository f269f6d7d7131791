package org.robotui.uic.sound.internal.alert;

import java.util.Optional;
import org.robotui.condition.Signals;
import org.robotui.condition.Verdict;

/** An alert that watches its condition. One thread. */
public final class Alert {
  /** How an alert is doing. */
  public enum State {
    /** As it should be. */
    QUIET,
    /** The condition holds, but not for long enough yet. */
    PENDING,
    /** The alert is on. */
    ACTIVE,
    /** It cannot be told. */
    UNKNOWN
  }

  /** What became of an alert in a step. */
  public enum Step {
    /** Nothing new. */
    NONE,
    /** It began. */
    RAISED,
    /** It is heard again. */
    REPEATED,
    /** It is on as before, with another value perhaps. */
    LASTS,
    /** It ended. */
    ENDED,
    /** Its configuration turned out to be wrong. */
    WRONG
  }

  private static final long SHORTEST_PAUSE_NANOS = 1_000_000_000L;

  private final AlertConfig config;
  private State state = State.UNKNOWN;
  private String detail = "";
  private Optional<Verdict.Holds> seen = Optional.empty();
  private boolean active;
  private long since;
  private long heard;
  private boolean everHeard;
  private boolean wrong;

  /** An alert that has not looked yet. */
  public Alert(AlertConfig config) {
    this.config = config;
  }

  /** How it was configured. */
  public AlertConfig config() {
    return config;
  }

  /** How it is doing. */
  public State state() {
    return state;
  }

  /** What it saw last, in words. */
  public String detail() {
    return detail;
  }

  /** What was seen last when the condition held. */
  public Optional<Verdict.Holds> seen() {
    return seen;
  }

  /** Looks at the robot. */
  public Step step(Signals signals, long nowNanos) {
    return switch (config.condition().check(signals, active)) {
      case Verdict.Holds holds -> holds(holds, nowNanos);
      case Verdict.Fails fails -> fails();
      case Verdict.Unknown unknown -> unknown(unknown);
    };
  }

  private Step holds(Verdict.Holds what, long now) {
    seen = Optional.of(what);
    detail = what.detail();
    if (config.condition().momentary()) {
      return moment(now);
    }
    if (active) {
      state = State.ACTIVE;
      boolean due = config.repeatNanos() > 0 && now - heard >= config.repeatNanos();
      heard = due ? now : heard;
      return due ? Step.REPEATED : Step.LASTS;
    }
    since = state == State.PENDING ? since : now;
    boolean raised = now - since >= config.forNanos();
    state = raised ? State.ACTIVE : State.PENDING;
    active = raised;
    heard = raised ? now : heard;
    return raised ? Step.RAISED : Step.NONE;
  }

  /** Each entry of a log is an alert of its own, but a flood of them is one. */
  private Step moment(long now) {
    state = State.ACTIVE;
    boolean due = !everHeard || now - heard >= Math.max(SHORTEST_PAUSE_NANOS, config.repeatNanos());
    if (due) {
      everHeard = true;
      heard = now;
    }
    return due ? Step.RAISED : Step.NONE;
  }

  private Step fails() {
    boolean ended = active;
    active = false;
    state = State.QUIET;
    return ended ? Step.ENDED : Step.NONE;
  }

  /** What was on stays on, but is not heard again before it is known. */
  private Step unknown(Verdict.Unknown unknown) {
    boolean told = wrong;
    wrong |= unknown.wrong();
    state = State.UNKNOWN;
    detail = unknown.reason();
    return wrong && !told ? Step.WRONG : Step.NONE;
  }
}
