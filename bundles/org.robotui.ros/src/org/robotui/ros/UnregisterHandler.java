package org.robotui.ros;

import java.net.InetSocketAddress;

/**
 * Takes what shall be said in this process's place when it is stopped or killed. Called on threads of the node; must
 * not wait.
 */
@FunctionalInterface
public interface UnregisterHandler {

  /**
   * Keeps words. They may be said more than once, and in any order.
   *
   * @param to whom to say them; resolved
   * @param words what is sent over a connection of its own; what is answered may be dropped
   * @return withdraws them
   */
  Runnable leave(InetSocketAddress to, byte[] words);

  /**
   * Nobody takes them.
   *
   * @return keeps nothing
   */
  static UnregisterHandler none() {
    return (to, words) -> () -> {};
  }
}
