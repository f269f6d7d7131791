package org.robotui.lcm.internal.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmListener;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmStatistics;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.Subscription;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.net.thread.Workers;

/** One connection: subscriptions on one side, and a link that is opened again when it broke on the other. */
public final class LcmClient implements Lcm {

  private static final Duration CLOSING = Duration.ofMillis(900);

  private final LcmUrl url;
  private final Counters counters = new Counters();
  private final Subscriptions subscriptions = new Subscriptions(counters);
  private final Workers workers;
  private final LinkKeeper keeper;
  private boolean closed;

  private LcmClient(LcmUrl url, LcmOptions options) {
    this.url = url;
    this.workers = new Workers(options.threads());
    this.keeper = new LinkKeeper(Providers.of(url, options, subscriptions), options, subscriptions);
  }

  public static LcmClient open(LcmUrl url, LcmOptions options) {
    LcmClient client = new LcmClient(url, options);
    client.workers.start("LCM " + url, client.keeper::run);
    return client;
  }

  public static void check(LcmUrl url) {
    Providers.of(url, LcmOptions.standard(Thread.ofPlatform().factory()), new Subscriptions(new Counters()));
  }

  @Override
  public LcmUrl url() {
    return url;
  }

  @Override
  public void publish(String channel, ByteBuffer data) throws IOException {
    byte[] name = Channels.encode(channel);
    int size = data.remaining();
    try {
      keeper.link().publish(name, data.duplicate());
    } catch (IOException e) {
      throw new IOException("a message of " + size + " bytes for " + channel + " was not sent: " + e.getMessage(), e);
    }
    counters.published(size);
  }

  @Override
  public Subscription subscribe(String channels, SubscriptionOptions options, LcmListener listener) {
    LiveSubscription subscription = new LiveSubscription(pattern(channels), options, listener, counters, this::forget);
    synchronized (this) {
      if (closed) {
        throw new IllegalStateException(url + " is closed");
      }
      if (subscription.isQueued()) {
        workers.start("LCM queue of " + channels, subscription::work);
      }
      subscriptions.add(subscription);
    }
    keeper.subscribed(channels);
    return subscription;
  }

  private static Pattern pattern(String channels) {
    try {
      return Pattern.compile(channels);
    } catch (PatternSyntaxException e) {
      throw new IllegalArgumentException(
          "'" + channels + "' is no regular expression of channels: " + e.getDescription()
              + " at character " + (e.getIndex() + 1) + "; write for example POSE|LASER_.*",
          e);
    }
  }

  private void forget(LiveSubscription subscription) {
    if (subscriptions.remove(subscription)) {
      keeper.unsubscribed(subscription.channels());
    }
  }

  @Override
  public LcmState state() {
    return keeper.state();
  }

  @Override
  public LcmStatistics statistics() {
    keeper.present().ifPresent(Link::tidy);
    return counters.figures();
  }

  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
    }
    keeper.close();
    subscriptions.all().forEach(LiveSubscription::close);
    workers.join(System.nanoTime() + CLOSING.toNanos());
  }
}
