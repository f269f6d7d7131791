package org.robotui.player.client;

/** Hears of the state of the link to a server. */
@FunctionalInterface
public interface LinkListener {

  /**
   * The link changed its state. Called on the receiving thread; must not block.
   *
   * @param state the new state
   */
  void onLink(LinkState state);

  /**
   * A listener that does nothing.
   *
   * @return the listener
   */
  static LinkListener none() {
    return state -> {};
  }
}
