package org.robotui.api.link;

/** Takes what a robot interface says of its link. */
@FunctionalInterface
public interface LinkReporter {
  /**
   * Reports a state. Called on any thread; never blocks.
   *
   * @param state the state from now on
   */
  void report(LinkState state);
}
