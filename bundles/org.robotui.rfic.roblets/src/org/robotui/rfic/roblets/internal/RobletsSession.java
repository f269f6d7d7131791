package org.robotui.rfic.roblets.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.rfic.roblets.internal.call.RobletsBrowser;
import org.robotui.rfic.roblets.internal.call.RobletsCalls;
import org.robotui.rfic.roblets.internal.call.RobletsPorts;
import org.robotui.rfic.roblets.internal.feed.BodyFeeds;
import org.robotui.rfic.roblets.internal.feed.RobletsShared;
import org.robotui.roblets.watch.BodyWatcher;

/** One watcher of a brain, and all that is offered of its roblets. */
final class RobletsSession implements RobotSession {
  private static final long LOOK_MILLIS = 50;
  private static final long FIRST_NANOS = Duration.ofMillis(1500).toNanos();
  private static final long SILENCE_NANOS = Duration.ofMillis(1800).toNanos();
  private static final long END_NANOS = Duration.ofSeconds(6).toNanos();

  private final RobletsSettings settings;
  private final LinkChanges link;
  private final BodyFeeds feeds;
  private final BodyWatcher watcher;
  private final List<Offer> offers;
  private volatile boolean closed;

  RobletsSession(RficContext context, RobletsSettings settings) throws IOException {
    this.settings = settings;
    this.link = new LinkChanges(context.link());
    RobletsShared shared = new RobletsShared(context, settings);
    this.feeds = new BodyFeeds(shared);
    try {
      this.watcher = new BodyWatcher(shared.name(), settings.brain().resolve(), context.threads(), feeds);
    } catch (IOException e) {
      feeds.close();
      throw e;
    }
    feeds.begin(watcher);
    this.offers = List.of(context.offers().call(RobletsPorts.SERVICES, new RobletsCalls(feeds, watcher)),
        context.offers().browse(RobletsPorts.GRAPH, new RobletsBrowser(feeds)));
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException {
    long begun = System.nanoTime();
    while (!over.getAsBoolean() && !closed) {
      feeds.tick();
      long silence = watcher.silentNanos();
      boolean never = !watcher.isWelcome() && System.nanoTime() - begun > FIRST_NANOS;
      if (never || silence > END_NANOS || watcher.isUnreachable() && silence > SILENCE_NANOS) {
        throw new IOException("no brain answers at " + settings.peer() + (watcher.isUnreachable()
            ? ": nothing listens there; start it"
            : "; start it")
            + ", or correct host and port, or ROBLETS_BRAIN, where it is elsewhere");
      }
      if (watcher.isWelcome()) {
        link.report(silence < SILENCE_NANOS ? new LinkState.Connected(feeds.robot() + " at " + settings.peer())
            : new LinkState.Degraded(settings.peer(), "the brain has been silent for " + silence / 1_000_000_000
                + " s; what is shown is old"));
      }
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  /** Stops what we drive, and takes leave of the brain. */
  @Override
  public void close() {
    closed = true;
    offers.forEach(Offer::close);
    feeds.close();
    watcher.close();
  }
}
