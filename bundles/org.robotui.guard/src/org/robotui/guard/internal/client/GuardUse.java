package org.robotui.guard.internal.client;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.net.SocketFactory;
import org.robotui.guard.Guard;
import org.robotui.guard.GuardState;

/** What one user has of a shared guard. */
final class GuardUse implements Guard {
  private final SharedGuard shared;
  private final SocketFactory sockets;
  private final Set<Farewell> farewells = ConcurrentHashMap.newKeySet();
  private final AtomicBoolean closed = new AtomicBoolean();

  GuardUse(SharedGuard shared) {
    this.shared = shared;
    this.sockets = new GuardedSockets(shared);
  }

  @Override
  public SocketFactory sockets() {
    return sockets;
  }

  @Override
  public Farewell farewell(InetSocketAddress to, byte[] words) {
    Optional<Integer> id = closed.get() ? Optional.empty() : shared.keep(to, words);
    Farewell farewell = new Farewell() {
      @Override
      public void close() {
        farewells.remove(this);
        id.ifPresent(shared::withdraw);
      }
    };
    farewells.add(farewell);
    return farewell;
  }

  @Override
  public GuardState state() {
    return shared.state();
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      farewells.forEach(Farewell::close);
      shared.release();
    }
  }
}
