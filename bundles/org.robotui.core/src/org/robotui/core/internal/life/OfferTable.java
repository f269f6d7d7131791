package org.robotui.core.internal.life;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.command.CommandOutcome.Refused;
import org.robotui.api.command.Principal;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Offer;
import org.robotui.api.port.Offers;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.Publication;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.command.CommandTarget;
import org.robotui.core.internal.command.GuardedBrowser;
import org.robotui.core.internal.fence.FencedBrowser;
import org.robotui.core.internal.fence.FencedDemand;
import org.robotui.core.internal.fence.FencedHandler;
import org.robotui.core.internal.fence.FencedSink;
import org.robotui.core.internal.port.BrowseTarget;
import org.robotui.core.internal.port.CallTarget;
import org.robotui.core.internal.port.Offered;
import org.robotui.core.internal.port.StampedStream;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.geometry.TransformSet;

/** What one instance of a robot interface offers now. */
final class OfferTable implements Offers {
  private record Key(PortKind kind, String name) {}

  /** The offers as they were after a number of changes. */
  private record Sorted(long after, List<Offered> offers) {}

  private final RficParts parts;
  private final Map<Key, Offered> offers = new ConcurrentHashMap<>();
  private final AtomicLong changes = new AtomicLong();
  private volatile Sorted sorted = new Sorted(0, List.of());
  private volatile long changedAt;
  private volatile boolean closed;

  OfferTable(RficParts parts) {
    this.parts = parts;
    this.changedAt = parts.clock().nanos();
  }

  @Override
  public <T extends Data> Publication<T> stream(StreamPort<T> port, Demand demand) {
    StreamSource<T> source = add(new StreamSource<>(
        id(port.name()), port, parts.link(), parts.clock(), parts.ages(), new FencedDemand(demand), parts.background(),
        this::remove));
    return measures(port.dataType()) ? new StampedStream<>(source, parts.stamps()) : source;
  }

  /** Whether the newest value is the newest measurement; transforms are looked at one by one. */
  private static boolean measures(DataType type) {
    return type.expires() && type.type() != TransformSet.class;
  }

  @Override
  public <T extends Data> Offer command(CommandPort<T> port, CommandSink<T> sink) {
    return add(new CommandTarget<>(
        id(port.name()), port, new FencedSink<>(sink, parts.origin()), parts.link(), parts.arbiter(), parts.sender(),
        parts.clock(), this::remove));
  }

  @Override
  public <Q, R> Offer call(CallPort<Q, R> port, CallHandler<Q, R> handler) {
    return add(new CallTarget<>(
        id(port.name()), port, new FencedHandler<>(handler, parts.origin()),
        port.guarded() ? parts.tasks() : parts.calls(), this::obstacle,
        parts.timer(), parts.clock(), this::remove));
  }

  @Override
  public Offer browse(BrowsePort port, Browser browser) {
    Browser fenced = new FencedBrowser(browser, parts.origin());
    return add(new BrowseTarget(
        id(port.name()), port, who -> new GuardedBrowser(fenced, parts.arbiter(), who), this::remove));
  }

  private Optional<String> obstacle(Principal principal) {
    return parts.arbiter().notAllowed(principal).map(Refused::explanation);
  }

  private SourceId id(String port) {
    return new SourceId(parts.component(), port);
  }

  private <O extends Offered> O add(O offered) {
    Key key = key(offered);
    if (closed) {
      return offered; // an instance that was given up still runs somewhere; nobody listens to it
    }
    if (offers.putIfAbsent(key, offered) instanceof Offered) {
      throw new IllegalStateException(
          parts.component() + " offers the " + key.kind() + " '" + key.name() + "' already");
    }
    changed();
    return offered;
  }

  private void remove(Offered offered) {
    if (offers.remove(key(offered), offered)) {
      changed();
    }
  }

  private void changed() {
    changes.incrementAndGet();
    changedAt = parts.clock().nanos();
    parts.changed().run();
  }

  private static Key key(Offered offered) {
    return new Key(offered.port().kind(), offered.port().name());
  }

  /**
   * All offers, sorted by kind and name. There may be thousands, and it is asked for many times a second: they are
   * sorted once.
   */
  List<Offered> list() {
    Sorted known = sorted;
    long now = changes.get();
    if (known.after() != now) {
      known = new Sorted(now, sort());
      sorted = known;
    }
    return known.offers();
  }

  private List<Offered> sort() {
    return offers.values().stream()
        .sorted(Comparator.comparing((Offered o) -> o.port().kind()).thenComparing(o -> o.port().name())).toList();
  }

  /** The command ports. */
  List<CommandTarget<?>> commands() {
    return offers.values().stream()
        .<CommandTarget<?>>mapMulti((o, out) -> {
          if (o instanceof CommandTarget<?> c) {
            out.accept(c);
          }
        }).toList();
  }

  /** The call ports. */
  List<CallTarget<?, ?>> calls() {
    return offers.values().stream()
        .<CallTarget<?, ?>>mapMulti((o, out) -> {
          if (o instanceof CallTarget<?, ?> c) {
            out.accept(c);
          }
        }).toList();
  }

  /** When something was last offered or withdrawn. */
  long changedAt() {
    return changedAt;
  }

  /** Withdraws all. */
  void close() {
    closed = true;
    offers.values().forEach(Offered::close);
  }
}
