package org.robotui.net.socket;

import java.io.Closeable;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The open sockets of one owner: closing the set closes them all, and what is added later at once. Safe for all
 * threads.
 */
public final class CloseableSet implements Closeable {

  private final Set<Closeable> open = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;

  /**
   * Adds a resource, or closes it if the set is closed already.
   *
   * @param resource to be closed with the set
   * @return false if it was closed
   */
  public boolean add(Closeable resource) {
    open.add(resource);
    if (closed) {
      close(resource);
    }
    return !closed;
  }

  /**
   * Closes one resource and forgets it.
   *
   * @param resource in the set or not
   */
  public void close(Closeable resource) {
    open.remove(resource);
    Sockets.closeQuietly(resource);
  }

  /**
   * Drops a resource that closes itself.
   *
   * @param resource in the set or not
   */
  public void forget(Closeable resource) {
    open.remove(resource);
  }

  /**
   * How many are open.
   *
   * @return those that were added and neither closed through the set nor forgotten
   */
  public int size() {
    return open.size();
  }

  /** Closes all of them, without an error. */
  @Override
  public void close() {
    closed = true;
    open.forEach(this::close);
  }
}
