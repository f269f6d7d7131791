package org.robotui.rfic.foxglove.internal.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.data.status.Severity;
import org.robotui.foxglove.FoxgloveListener;
import org.robotui.foxglove.Parameter;
import org.robotui.message.topic.ServerNotices;

/** Remembers what a server said beside messages, until somebody asks. Safe for all threads. */
public final class ServerNews implements FoxgloveListener {
  private static final int MOST_PARAMETERS = 20_000;

  private final ServerNotices notices;
  private final AtomicBoolean offers = new AtomicBoolean(true);
  private final Map<String, Object> parameters = new ConcurrentHashMap<>();
  private volatile Optional<Ends> ends = Optional.empty();
  private volatile OptionalLong time = OptionalLong.empty();

  /**
   * Who is at the ends of topics, by the server's names of them.
   *
   * @param publishers who publishes
   * @param subscribers who subscribes
   */
  public record Ends(Map<String, Set<String>> publishers, Map<String, Set<String>> subscribers) {}

  /** Nothing was heard yet of a server, which is named in what is logged. */
  ServerNews(String server) {
    this.notices = new ServerNotices(server);
  }

  @Override
  public void onUnreadable(String reason) {
    notices.unreadable(reason);
  }

  @Override
  public void onOffers() {
    offers.set(true);
  }

  @Override
  public void onTime(long nanos) {
    time = OptionalLong.of(nanos);
  }

  @Override
  public void onStatus(int level, String message) {
    notices.said(level <= 0 ? Severity.INFO : level == 1 ? Severity.WARNING : Severity.ERROR, message);
  }

  @Override
  public void onGraph(Map<String, Set<String>> publishers, Map<String, Set<String>> subscribers) {
    ends = Optional.of(new Ends(publishers, subscribers));
  }

  @Override
  public void onParameters(List<Parameter> values) {
    values.stream().filter(p -> parameters.size() < MOST_PARAMETERS || parameters.containsKey(p.name()))
        .forEach(p -> parameters.put(p.name(), p.value()));
  }

  /** Whether the server has other channels or services than when this was asked last. */
  boolean takeOffers() {
    return offers.getAndSet(false);
  }

  /** What the server has told users. */
  ServerNotices notices() {
    return notices;
  }

  /** The server's time; none while it says none. */
  OptionalLong time() {
    return time;
  }

  /**
   * Who is at the ends of topics.
   *
   * @return none until the server has said it
   */
  public Optional<Ends> ends() {
    return ends;
  }

  /**
   * The newest values of parameters that are followed.
   *
   * @return by name; what is removed here comes again when it changes
   */
  public Map<String, Object> parameters() {
    return parameters;
  }
}
