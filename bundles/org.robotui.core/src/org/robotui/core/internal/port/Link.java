package org.robotui.core.internal.port;

import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.link.LinkState;
import org.robotui.core.internal.time.NanoClock;

/** The link of one robot interface, as it last reported it. */
public final class Link implements LinkReporter {
  private record Now(LinkState state, long since, long generation) {}

  private final NanoClock clock;
  private final Runnable changed;
  private final AtomicReference<Now> now;

  /**
   * A link that nothing is known of.
   *
   * @param clock monotonic
   * @param changed is told of changes on the reporting thread; must not block
   */
  public Link(NanoClock clock, Runnable changed) {
    this.clock = clock;
    this.changed = changed;
    this.now = new AtomicReference<>(new Now(new LinkState.Disconnected(), clock.nanos(), 0));
  }

  @Override
  public void report(LinkState state) {
    Now before = now.getAndUpdate(n -> n.state().equals(state) ? n : next(n, state));
    if (!before.state().equals(state)) {
      changed.run();
    }
  }

  private Now next(Now before, LinkState state) {
    boolean lost = isUp(before.state()) && !isUp(state);
    boolean came = !isUp(before.state()) && isUp(state);
    return new Now(state, came || lost ? clock.nanos() : before.since(), before.generation() + (lost ? 1 : 0));
  }

  /** The state. */
  public LinkState state() {
    return now.get().state();
  }

  /** True while the peer answers. */
  public boolean isUp() {
    return isUp(state());
  }

  /** Since when it is up, or down, by the monotonic clock. */
  public long since() {
    return now.get().since();
  }

  /** Counts how often it was lost, so that nothing survives a reconnection. */
  public long generation() {
    return now.get().generation();
  }

  /** A sentence on the state. */
  public String text() {
    LinkState state = state();
    return state.reason().isEmpty() ? state.word() : state.word() + ": " + state.reason();
  }

  private static boolean isUp(LinkState state) {
    return state instanceof LinkState.Connected || state instanceof LinkState.Degraded;
  }
}
