package org.robotui.api.session;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficWorker;
import org.robotui.api.link.LinkState;

/**
 * A robot interface that is one session after another. Sessions are opened, followed and closed on one thread; at the
 * end the session is closed beside it, so that whatever blocks there ends.
 */
public final class SessionRfic implements Rfic {
  private static final Duration END = Duration.ofSeconds(2);

  private final RficContext context;
  private final String peer;
  private final SessionFactory sessions;
  private final RficWorker worker;
  private final AtomicReference<Optional<OnceClosed>> current = new AtomicReference<>(Optional.empty());

  /**
   * Nothing happens before the start.
   *
   * @param context what core gives
   * @param peer to whom it connects, for users
   * @param retry how long after the end of a session the next one is opened
   * @param sessions opens them
   */
  public SessionRfic(RficContext context, String peer, Duration retry, SessionFactory sessions) {
    this.context = context;
    this.peer = peer;
    this.sessions = sessions;
    this.worker = new RficWorker(context, retry, this::follow);
  }

  @Override
  public void start() {
    worker.start(peer);
  }

  private String follow(BooleanSupplier over) throws IOException, InterruptedException {
    Optional<String> end = Optional.empty();
    while (end.isEmpty() && !over.getAsBoolean()) {
      end = followOne(over);
    }
    return end.orElse("closed");
  }

  private Optional<String> followOne(BooleanSupplier over) throws IOException, InterruptedException {
    SessionScope scope = new SessionScope();
    try {
      RobotSession session = sessions.open(scope);
      OnceClosed closing = scope.closing(new OnceClosed(session), OnceClosed::close);
      current.set(Optional.of(closing));
      return over.getAsBoolean() ? Optional.empty() : session.follow(over);
    } finally {
      scope.close();
    }
  }

  /**
   * Closes the session and waits for its thread: two seconds at most, also where the session hangs, and no shorter
   * where this thread is interrupted. What still runs then is seen by core, as it owns the threads.
   */
  @Override
  public void close() {
    worker.stop();
    long deadline = System.nanoTime() + END.toNanos();
    current.get().ifPresent(session -> {
      Thread closing = context.threads().newThread(session::close);
      closing.start();
      RficWorker.join(closing, deadline);
    });
    worker.join(Duration.ofNanos(Math.max(1, deadline - System.nanoTime())));
    context.link().report(new LinkState.Disconnected());
  }

  /** Closes a session once; whoever comes second waits until it is closed. */
  private static final class OnceClosed {
    private final RobotSession session;
    private boolean closed;

    OnceClosed(RobotSession session) {
      this.session = session;
    }

    synchronized void close() {
      if (!closed) {
        closed = true;
        session.close();
      }
    }
  }
}
