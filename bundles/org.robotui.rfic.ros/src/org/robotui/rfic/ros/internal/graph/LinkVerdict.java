package org.robotui.rfic.ros.internal.graph;

import java.time.Duration;
import java.util.Optional;
import org.robotui.api.link.LinkState;
import org.robotui.net.call.Outcome;

/** What the answers of a master, and those that do not come, say of the link to a robot. On the session's thread. */
final class LinkVerdict {
  private final String master;
  private final Duration look;
  private boolean met;
  private boolean late;

  /**
   * Nothing was asked yet.
   *
   * @param master its address
   * @param look how long after a failure it is asked again
   */
  LinkVerdict(String master, Duration look) {
    this.master = master;
    this.look = look;
  }

  /**
   * The master answered.
   *
   * @param problem what is wrong with a topic, or empty
   * @return the state of the link
   */
  LinkState answered(String problem) {
    met = true;
    late = false;
    return problem.isEmpty() ? new LinkState.Connected(master) : new LinkState.Degraded(master, problem);
  }

  /**
   * The master did not answer. Without it, established links go on: that is no failure of the robot, but nothing new
   * can be found. Over a network that loses packets now and then one answer is late, which is no news.
   *
   * @param outcome why
   * @param flowing whether topics are connected
   * @return the state of the link, or empty where it is as it was
   */
  Optional<LinkState> unanswered(Outcome<?> outcome, boolean flowing) {
    if (!met || !flowing) {
      return Optional.of(new LinkState.Failed(outcome.reason(), look));
    }
    boolean first = outcome instanceof Outcome.TimedOut && !late;
    late = true;
    return first ? Optional.empty()
        : Optional.of(new LinkState.Degraded(master, outcome.reason() + "; established links go on"));
  }
}
