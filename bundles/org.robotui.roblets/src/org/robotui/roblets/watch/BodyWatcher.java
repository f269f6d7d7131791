package org.robotui.roblets.watch;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ThreadFactory;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.internal.DatagramEndpoint;
import org.robotui.roblets.internal.SenderRun;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.ArrivalOrder;
import org.robotui.roblets.wire.BodyDatagram;
import org.robotui.roblets.wire.DatagramKind;
import org.robotui.roblets.wire.RobletStatus;

/**
 * Looks at a body: tells its brain twice a second which roblets it wants to hear, and takes what comes from there. The
 * brain forgets it after three seconds without that, so that nothing is left of one that was killed. Safe for all
 * threads.
 */
public final class BodyWatcher implements AutoCloseable {
  /** Stands for all roblets. */
  public static final String ALL = "*";

  private static final String BRAIN = "brain";
  private static final long AGAIN_NANOS = Duration.ofMillis(500).toNanos();
  private static final long FIRST_NANOS = Duration.ofMillis(100).toNanos();
  private static final int GOODBYES = 2;

  private final InetSocketAddress brain;
  private final BodyWatchListener listener;
  private final SenderRun sender;
  private final ArrivalOrder order = new ArrivalOrder();
  private final DatagramEndpoint endpoint;
  private volatile Set<String> wanted = Set.of();
  private volatile long heardAt = System.nanoTime();
  private volatile boolean welcomed;
  private volatile boolean unreachable;
  private volatile long watchAt = System.nanoTime();

  /**
   * Begins to look.
   *
   * @param name by which the brain knows it
   * @param brain where the brain is
   * @param threads makes its thread
   * @param listener hears of all
   * @throws IOException where there is no socket
   */
  public BodyWatcher(String name, InetSocketAddress brain, ThreadFactory threads, BodyWatchListener listener)
      throws IOException {
    this.brain = brain;
    this.listener = listener;
    this.sender = SenderRun.of(name);
    boolean near = brain.getAddress().isLoopbackAddress();
    this.endpoint = DatagramEndpoint.bound(
        new InetSocketAddress(near ? brain.getAddress() : InetAddress.getByName("0.0.0.0"), 0), "watcher " + name,
        threads);
    try {
      endpoint.connect(brain); // nobody else is heard
    } catch (IOException e) {
      endpoint.close();
      throw e;
    }
    endpoint.open(new Eyes());
  }

  /**
   * Says whom it wants to hear, at once and from now on.
   *
   * @param roblets their names, or {@link #ALL}
   */
  public void want(Set<String> roblets) {
    Set<String> now = Set.copyOf(roblets);
    if (!now.equals(wanted)) {
      wanted = now;
      watchAt = System.nanoTime();
      watch();
    }
  }

  /**
   * Asks the brain to say something to a roblet.
   *
   * @param roblet its name
   * @param message something that it takes
   * @return whether it was given to the network; whether it is heard is not told
   */
  public boolean ask(String roblet, BodyElement message) {
    return endpoint.say(sender, DatagramKind.REQUEST, roblet, Optional.of(message), brain);
  }

  /**
   * Whether the brain has answered.
   *
   * @return true from its first word on
   */
  public boolean isWelcome() {
    return welcomed;
  }

  /**
   * Whether this machine was told that nobody listens there.
   *
   * @return false again when the brain is heard
   */
  public boolean isUnreachable() {
    return unreachable;
  }

  /**
   * How long nothing has come from the brain.
   *
   * @return nanoseconds
   */
  public long silentNanos() {
    return System.nanoTime() - heardAt;
  }

  private void watch() {
    BodyElement watch = BodyElement.of("watch").with(
        wanted.stream().sorted().map(roblet -> BodyElement.of("want").with("roblet", roblet)).toList());
    endpoint.say(sender, DatagramKind.WATCH, BRAIN, Optional.of(watch), brain);
  }

  /** Tells the brain that it goes, and ends. */
  @Override
  public void close() {
    for (int i = 0; i < GOODBYES; i++) {
      endpoint.say(sender, DatagramKind.LEAVE, BRAIN, Optional.empty(), brain);
    }
    endpoint.close();
  }

  /** What is done with datagrams, on the reading thread. */
  private final class Eyes implements DatagramEndpoint.Handler {
    @Override
    public void arrived(BodyDatagram datagram, byte[] bytes, InetSocketAddress from, long nowNanos) {
      heardAt = nowNanos;
      unreachable = false;
      switch (datagram.kind()) {
        case WELCOME -> {
          welcomed = true;
          listener.welcomed(datagram.body().flatMap(body -> body.attribute("robot")).orElse(""));
        }
        case ROSTER -> datagram.body().ifPresent(body -> listener.roster(RobletStatus.of(body)));
        case MESSAGE -> said(datagram, bytes, nowNanos);
        default -> {
          // for brains
        }
      }
    }

    private void said(BodyDatagram datagram, byte[] bytes, long nowNanos) {
      if (order.judge(datagram, nowNanos).isNew() && datagram.body().isPresent()) {
        listener.said(datagram.from(),
            new BodyEntry(datagram.body().get(), nowNanos, datagram.stampNanos(), datagram.sequence()), bytes);
      }
    }

    @Override
    public void unreadable(String reason, InetSocketAddress from) {
      listener.unreadable(reason);
    }

    @Override
    public void unreachable() {
      unreachable = true;
    }

    @Override
    public void idle(long nowNanos) {
      if (nowNanos - watchAt >= 0) {
        watchAt = nowNanos + (welcomed ? AGAIN_NANOS : FIRST_NANOS);
        watch();
      }
    }
  }
}
