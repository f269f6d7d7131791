package org.robotui.api.session;

import java.util.Optional;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.link.LinkState;

/**
 * Reports the state of a link only when it has changed, for sessions that look at it again and again. For one thread.
 */
public final class LinkChanges {
  private final LinkReporter link;
  private Optional<LinkState> told = Optional.empty();

  /**
   * Nothing has been told yet.
   *
   * @param link hears of changes
   */
  public LinkChanges(LinkReporter link) {
    this.link = link;
  }

  /**
   * Reports a state unless it is the latest that was reported here.
   *
   * @param state the state from now on
   */
  public void report(LinkState state) {
    if (!told.equals(Optional.of(state))) {
      told = Optional.of(state);
      link.report(state);
    }
  }
}
