package org.robotui.ros.internal.io;

import java.io.Closeable;
import java.io.IOException;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The open sockets of one owner: closing the set closes them all, and what is added later at once. */
public final class Closeables implements Closeable {

  private static final Logger LOG = LoggerFactory.getLogger(Closeables.class);

  private final Set<Closeable> open = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;

  /** Adds a resource; answers false, with the resource closed, if the set is closed already. */
  public boolean add(Closeable resource) {
    open.add(resource);
    if (closed) {
      close(resource);
    }
    return !closed;
  }

  /** Closes one resource and forgets it. */
  public void close(Closeable resource) {
    open.remove(resource);
    quietly(resource);
  }

  /** Drops a resource that closes itself. */
  public void forget(Closeable resource) {
    open.remove(resource);
  }

  /** How many are open. */
  public int size() {
    return open.size();
  }

  @Override
  public void close() {
    closed = true;
    open.forEach(this::close);
  }

  /** Closes without an error: nothing can be done about a socket that does not close. */
  public static void quietly(Closeable resource) {
    try {
      resource.close();
    } catch (IOException e) {
      LOG.debug("closing {}", resource, e);
    }
  }
}
