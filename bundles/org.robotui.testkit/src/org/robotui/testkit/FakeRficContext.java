package org.robotui.testkit;

import java.nio.file.Path;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.RficContext;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Offers;
import org.robotui.api.port.Port;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.time.ClockSource;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;

/** Stands in for core: records what a robot interface offers, publishes and reports. Safe for all threads. */
public final class FakeRficContext implements RficContext, Offers, ClockSource {
  /**
   * A value that was published.
   *
   * @param value the value
   * @param stamp when it was measured
   * @param receivedNanos when its bytes were received, {@link System#nanoTime()}
   * @param raw the message as it came
   */
  public record Published(Data value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {}

  /** The streams that are offered now, by name. */
  public final Map<String, StreamPort<?>> streams = new ConcurrentHashMap<>();
  /** Who is told of demand, by stream. */
  public final Map<String, Demand> demands = new ConcurrentHashMap<>();
  /** What was published so far, by stream. */
  public final Map<String, Deque<Published>> published = new ConcurrentHashMap<>();
  /** What was lost or failed and why, by stream. */
  public final Map<String, Deque<String>> complaints = new ConcurrentHashMap<>();
  /** Whether the values of a stream hold until the next one, by stream. */
  public final Map<String, Boolean> kept = new ConcurrentHashMap<>();
  /** What is promised of the delivery of a stream, by stream. */
  public final Map<String, String> deliveries = new ConcurrentHashMap<>();
  /** All that recordings have, by port. */
  public final Map<String, StreamHistory> histories = new ConcurrentHashMap<>();
  /** The command ports that are offered now, by name. */
  public final Map<String, CommandPort<?>> commands = new ConcurrentHashMap<>();
  /** Who takes commands, by port. */
  public final Map<String, CommandSink<?>> sinks = new ConcurrentHashMap<>();
  /** Who answers calls now, by port. */
  public final Map<String, CallHandler<?, ?>> handlers = new ConcurrentHashMap<>();
  /** Who is browsed now, by port. */
  public final Map<String, Browser> browsers = new ConcurrentHashMap<>();
  /** The states of the link so far. */
  public final Deque<LinkState> links = new ConcurrentLinkedDeque<>();
  /** The transforms so far. */
  public final Deque<FrameTransform> transforms = new ConcurrentLinkedDeque<>();
  /** The simulated times so far, nanoseconds. */
  public final Deque<Long> simulated = new ConcurrentLinkedDeque<>();
  /** The times to which a recording was moved, nanoseconds. */
  public final Deque<Long> moves = new ConcurrentLinkedDeque<>();
  /** Who was told that a stream is wanted, by stream. */
  private final Map<String, Demand> wanted = new ConcurrentHashMap<>();
  /** All threads that were made. */
  public final Set<Thread> threads = ConcurrentHashMap.newKeySet();

  /** Without a robot interface. */
  public FakeRficContext() {
    // the robot interface fills it
  }

  @Override
  public String robot() {
    return "robby";
  }

  @Override
  public String instance() {
    return "base";
  }

  @Override
  public Offers offers() {
    return this;
  }

  @Override
  public LinkReporter link() {
    return links::add;
  }

  @Override
  public ThreadFactory threads() {
    return work -> {
      Thread thread = Thread.ofPlatform().daemon().name("test").unstarted(work);
      threads.add(thread);
      return thread;
    };
  }

  @Override
  public ClockSource clock() {
    return this;
  }

  @Override
  public Path stateFolder() {
    return Path.of(System.getProperty("java.io.tmpdir"), "robotui-test-" + ProcessHandle.current().pid());
  }

  @Override
  public FrameSink frames() {
    return (set, authority) -> transforms.addAll(set.transforms());
  }

  @Override
  public void simulated(long nanos) {
    simulated.add(nanos);
  }

  @Override
  public void moved(long nanos) {
    moves.add(nanos);
    simulated.add(nanos);
  }

  /** As if it had been played at its own speed all the time. */
  @Override
  public long received(long nanos) {
    Long last = simulated.peekLast();
    return System.nanoTime() - (last == null ? 0 : Math.max(0, last - nanos));
  }

  @Override
  public void live() {
    simulated.clear();
  }

  @Override
  public void observed(long stampNanos) {
    // only core estimates offsets
  }

  /**
   * The threads that run.
   *
   * @return those that were made and have not ended
   */
  public List<Thread> alive() {
    return threads.stream().filter(Thread::isAlive).toList();
  }

  /**
   * A first consumer comes or the last goes.
   *
   * @param port the stream
   * @param wanted true where one comes
   */
  public void demand(String port, boolean wanted) {
    Demand demand = demands.get(port);
    if (wanted) {
      this.wanted.put(port, demand);
    } else {
      this.wanted.remove(port);
    }
    demand.changed(wanted);
  }

  /**
   * Connects the consumers of streams that were withdrawn and are offered again, as core does when it matches ports
   * anew.
   */
  public void match() {
    wanted.forEach((port, told) -> {
      Demand demand = demands.getOrDefault(port, told);
      if (demand != told) {
        demand(port, true);
      }
    });
  }

  @Override
  public <T extends Data> Publication<T> stream(StreamPort<T> port, Demand demand) {
    once(demands.putIfAbsent(port.name(), demand));
    Publication<T> publication = new FakePublication<>(port.name());
    streams.put(port.name(), port); // last: a test that sees it demands it at once
    return publication;
  }

  @Override
  public <T extends Data> Offer command(CommandPort<T> port, CommandSink<T> sink) {
    sinks.put(port.name(), sink); // first: a test that sees the command sends at once
    once(commands.putIfAbsent(port.name(), port));
    return () -> commands.remove(port.name());
  }

  @Override
  public <Q, R> Offer call(CallPort<Q, R> port, CallHandler<Q, R> handler) {
    once(handlers.putIfAbsent(port.name(), handler));
    return () -> handlers.remove(port.name());
  }

  @Override
  public Offer browse(BrowsePort port, Browser browser) {
    once(browsers.putIfAbsent(port.name(), browser));
    return () -> browsers.remove(port.name());
  }

  private static void once(Port before) {
    if (before != null) {
      throw new IllegalStateException(before.name() + " is offered twice");
    }
  }

  private static void once(Object before) {
    if (before != null) {
      throw new IllegalStateException("offered twice");
    }
  }

  private final class FakePublication<T extends Data> implements Publication<T> {
    private final String port;

    FakePublication(String port) {
      this.port = port;
      published.putIfAbsent(port, new ConcurrentLinkedDeque<>());
      complaints.putIfAbsent(port, new ConcurrentLinkedDeque<>());
    }

    @Override
    public void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
      published.get(port).add(new Published(value, stamp, receivedNanos, raw));
    }

    @Override
    public void lost(long count, String reason) {
      complaints.get(port).add(reason);
    }

    @Override
    public void kept(boolean forLateComers) {
      kept.put(port, forLateComers);
    }

    @Override
    public void forget() {
      published.get(port).clear();
    }

    @Override
    public void delivery(String promise) {
      deliveries.put(port, promise);
    }

    @Override
    public void history(StreamHistory all) {
      histories.put(port, all);
    }

    @Override
    public void failed(String reason) {
      complaints.get(port).add(reason);
    }

    @Override
    public void close() {
      streams.remove(port);
      demands.remove(port);
    }
  }
}
