package org.robotui.foxglove.internal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.web.Arrivals;

/**
 * Who receives which channel. A server knows at most one subscription of a client to a channel, so that those who
 * receive the same one share it. Safe for all threads.
 */
public final class ChannelFeeds {

  private final ServerState ear;
  private final Consumer<Map<String, Object>> say;
  private final Map<Long, Feed> feeds = new HashMap<>();
  private int ids;

  /** A subscription, and who shares it. */
  private record Feed(long id, List<Arrivals.Source<Binary.Data>> sources) {
    void arrived(Binary.Data data) {
      sources.forEach(source -> source.arrived(data));
    }
  }

  /**
   * Nobody receives anything.
   *
   * @param ear hands over what comes
   * @param say says something to the server
   */
  public ChannelFeeds(ServerState ear, Consumer<Map<String, Object>> say) {
    this.ear = ear;
    this.say = say;
  }

  /** A source receives a channel from now on. */
  public synchronized void add(long channel, Arrivals.Source<Binary.Data> source) {
    Feed known = feeds.get(channel);
    if (known != null) {
      known.sources().add(source);
      return;
    }
    Feed feed = new Feed(++ids, new CopyOnWriteArrayList<>(List.of(source)));
    feeds.put(channel, feed);
    ear.subscribed(feed.id(), feed::arrived);
    say.accept(Graph.message("subscribe", "subscriptions", List.of(Map.of("id", feed.id(), "channelId", channel))));
  }

  /** It does so no more. */
  public synchronized void remove(long channel, Arrivals.Source<Binary.Data> source) {
    Feed feed = feeds.get(channel);
    if (feed != null && feed.sources().remove(source) && feed.sources().isEmpty()) {
      feeds.remove(channel);
      ear.unsubscribed(feed.id());
      say.accept(Graph.message("unsubscribe", "subscriptionIds", List.of(feed.id())));
    }
  }
}
