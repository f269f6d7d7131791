package org.robotui.rfic.roblets.internal.feed;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListMap;
import org.robotui.api.port.Publication;
import org.robotui.data.status.BodyState;
import org.robotui.data.status.Diagnostics;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.roblets.ElementRecord;
import org.robotui.rfic.roblets.internal.call.RobletsPorts;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.body.Bodymap;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.watch.BodyWatchListener;
import org.robotui.roblets.watch.BodyWatcher;
import org.robotui.roblets.wire.RobletStatus;

/**
 * The roblets of a body as ports, and the body as a whole. Hears on the thread of the watcher; {@link #tick} is for the
 * one that follows.
 */
public final class BodyFeeds implements BodyWatchListener, AutoCloseable {
  private static final int MOST_PORTS = 1024;
  private static final long BODY_NANOS = 200_000_000;
  private static final double NANOS = 1e9;
  private static final double LATE_SECONDS = 1.5;

  private final RobletsShared shared;
  private final Bodymap body = new Bodymap(1);
  private final Map<String, RobletStatus> statuses = new ConcurrentSkipListMap<>();
  private final Map<String, RobletFeed> feeds = new ConcurrentSkipListMap<>();
  private final Publication<BodyState> whole;
  private volatile boolean wholeWanted;
  private volatile String robot = "";
  private volatile RigidTransform moved = RigidTransform.IDENTITY;
  private volatile Optional<BodyWatcher> watcher = Optional.empty();
  private boolean closed; // guarded by this, as the following
  private int ports;
  private long wholeAt = System.nanoTime(); // only on the thread that follows

  /** Something that a roblet takes. */
  public record Input(String roblet, BodyForm form) {}

  public BodyFeeds(RobletsShared shared) {
    this.shared = shared;
    this.whole = shared.context().offers().stream(RobletsPorts.BODY, now -> wholeWanted = now);
  }

  /** Where wishes and messages go to. */
  public void begin(BodyWatcher to) {
    watcher = Optional.of(to);
  }

  public String robot() {
    return robot.isEmpty() ? "a brain" : robot;
  }

  public List<RobletStatus> statuses() {
    return List.copyOf(statuses.values());
  }

  public Optional<RobletStatus> status(String roblet) {
    return Optional.ofNullable(statuses.get(roblet));
  }

  /** What is called {@code ROBLET/MESSAGE}. */
  public Optional<Input> input(String name) {
    String[] parts = name.split("/", 2);
    return parts.length < 2 ? Optional.empty()
        : status(parts[0]).flatMap(s -> s.form().input(parts[1])).map(form -> new Input(parts[0], form));
  }

  /** Why a roblet is not told anything now. */
  public Optional<String> refusal(String roblet) {
    double silence = watcher.map(BodyWatcher::silentNanos).orElse(0L) / NANOS;
    if (silence > LATE_SECONDS) {
      return Optional.of(String.format(Locale.ROOT,
          "the brain has been silent for %.1f s; nothing is sent into a network that may keep it", silence));
    }
    return status(roblet).filter(s -> !s.state().equals(RobletStatus.RUNNING))
        .map(s -> "the roblet " + roblet + " is " + s.state() + (s.reason().isEmpty() ? "" : ": " + s.reason()));
  }

  boolean ask(String roblet, BodyElement message) {
    return watcher.filter(w -> w.ask(roblet, message)).isPresent();
  }

  void moved(RigidTransform to) {
    moved = to;
  }

  RigidTransform moved() {
    return moved;
  }

  @Override
  public void welcomed(String name) {
    robot = name;
  }

  @Override
  public void roster(RobletStatus status) {
    String name = status.form().name();
    synchronized (this) {
      if (closed || ports > MOST_PORTS && !feeds.containsKey(name)) {
        return;
      }
      statuses.put(name, status);
      RobletFeed feed = feeds.computeIfAbsent(name, n -> new RobletFeed(shared, this, n));
      feed.offer(status.form());
      ports = feeds.size() + statuses.values().stream().mapToInt(s -> s.form().outputs().size()).sum();
      feed.failed(status.state().equals(RobletStatus.RUNNING) ? "" : refusal(name).orElse(""));
    }
  }

  @Override
  public void said(String roblet, BodyEntry entry, byte[] bytes) {
    shared.pulse().heard(entry.receivedNanos());
    body.put(roblet, entry);
    Optional.ofNullable(feeds.get(roblet)).ifPresent(feed -> feed.said(entry, bytes));
  }

  @Override
  public void unreadable(String reason) {
    feeds.values().forEach(feed -> feed.lost(reason));
  }

  /** Tells the brain what is wanted now, and says the whole body. */
  public void tick() {
    boolean carried = shared.tree().wanted() || feeds.values().stream().anyMatch(RobletFeed::placedAndWanted);
    Set<String> wanted = new HashSet<>();
    if (wholeWanted) {
      wanted.add(BodyWatcher.ALL);
    } else {
      feeds.forEach((name, feed) -> {
        if (feed.wanted(carried)) {
          wanted.add(name);
        }
      });
    }
    watcher.ifPresent(w -> w.want(wanted));
    long now = System.nanoTime();
    if (wholeWanted && now - wholeAt >= BODY_NANOS) {
      wholeAt = now;
      whole.publish(new BodyState(statuses.values().stream().map(s -> part(s, now)).toList()), Optional.empty());
    }
  }

  private BodyState.Part part(RobletStatus status, long now) {
    String name = status.form().name();
    List<BodyState.Saying> says = body.snapshot().parts().getOrDefault(name, Map.of()).entrySet().stream()
        .map(each -> new BodyState.Saying(each.getKey(), (now - each.getValue().receivedNanos()) / NANOS,
            ElementRecord.of(name + "/" + each.getKey(), each.getValue().element())))
        .toList();
    return new BodyState.Part(name, level(status), status.state(), status.reason(), status.silentSeconds(),
        status.restarts(), status.tally().received(), status.tally().lost(), says);
  }

  private static Diagnostics.Level level(RobletStatus status) {
    return switch (status.state()) {
      case RobletStatus.RUNNING -> Diagnostics.Level.OK;
      case RobletStatus.SILENT, RobletStatus.STOPPED -> Diagnostics.Level.STALE;
      case "failed" -> Diagnostics.Level.ERROR;
      default -> Diagnostics.Level.WARNING;
    };
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    feeds.values().forEach(RobletFeed::close);
    whole.close();
    shared.tree().close();
  }
}
