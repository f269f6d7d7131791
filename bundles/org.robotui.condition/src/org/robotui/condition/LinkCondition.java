package org.robotui.condition;

import java.util.function.Predicate;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Input;

/** The link to the robot was there and is lost. A robot that was never there is not missed. */
final class LinkCondition implements Condition {
  private boolean seen;

  @Override
  public Predicate<Input.Candidate> needs() {
    return candidate -> false;
  }

  @Override
  public Verdict check(Signals signals, boolean active) {
    LinkState link = signals.link();
    boolean up = link instanceof LinkState.Connected || link instanceof LinkState.Degraded;
    seen |= up;
    if (up) {
      return new Verdict.Fails();
    }
    return seen
        ? new Verdict.Holds("the link", "is", "lost: " + (link.reason().isEmpty() ? link.word() : link.reason()))
        : new Verdict.Unknown("the robot has not been connected yet", false);
  }
}
