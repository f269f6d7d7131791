package org.robotui.guard;

import java.net.InetSocketAddress;
import javax.net.SocketFactory;

/** What one user of a guard has of it. Safe for all threads. */
public interface Guard extends AutoCloseable {
  /**
   * Sockets whose other end the guard keeps. They connect as others do, and end when this process is silent for too
   * long or takes what the robot sends too slowly.
   *
   * @return makes unconnected sockets
   */
  SocketFactory sockets();

  /**
   * Leaves words that the guard says when this process is silent for too long, or is gone without having closed its
   * guard. They may be said more than once. Where they are too long or too many, they are not kept, and that is logged.
   *
   * @param to whom to say them; must be resolved
   * @param words what is sent over a connection of its own; the answer is read and dropped
   * @return withdraws them when closed
   */
  Farewell farewell(InetSocketAddress to, byte[] words);

  /** How the guard is doing. */
  GuardState state();

  /** Withdraws all farewells; the process ends with the last user. Sockets are closed by those who have them. */
  @Override
  void close();

  /** Words that are to be said. */
  interface Farewell extends AutoCloseable {
    /** Withdraws them. */
    @Override
    void close();
  }
}
