package org.robotui.lcm;

/** Hears of the state of a connection. */
@FunctionalInterface
public interface LcmStateListener {

  /**
   * The state changed. Called on the connection's thread; must not block.
   *
   * @param state the new state
   */
  void onState(LcmState state);

  /**
   * A listener that does nothing.
   *
   * @return the listener
   */
  static LcmStateListener none() {
    return state -> {};
  }
}
