package org.robotui.rfic.player.internal.device;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Offer;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.DeviceListener;
import org.robotui.player.client.DeviceState;
import org.robotui.player.client.PlayerDevice;
import org.robotui.player.client.Subscription;
import org.robotui.player.layout.Codec;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One device: its ports, and its subscription, which is held only while somebody needs it, as it may start a driver.
 * Data come on the receiving thread; {@link #tick} is for the thread that follows the devices.
 */
public final class DeviceFeed implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(DeviceFeed.class);
  private static final long LINGER_NANOS = 30_000_000_000L;
  /** What measures again and again. Others speak when something changes, and their silence says nothing. */
  private static final Set<String> MEASURING =
      Set.of("position2d", "position3d", "laser", "ranger", "sonar", "ir", "imu", "gps", "camera", "actarray",
          "pointcloud3d", "bumper", "fiducial");
  /** A localisation that is opened again forgets where the robot is, and its odometry comes on change. */
  private static final String LOCALISATION = "amcl";

  /** Takes data as they are on the wire. */
  private interface Taker {
    void take(PlayerMessage message, Reception reception) throws PlayerException;
  }

  private final PlayerDevice device;
  private final Surroundings around;
  private final List<Outlet<?>> outlets = new CopyOnWriteArrayList<>();
  private final List<Offer> commands = new CopyOnWriteArrayList<>();
  private final List<Runnable> openers = new CopyOnWriteArrayList<>();
  private final List<Runnable> losers = new CopyOnWriteArrayList<>();
  private final List<LongConsumer> tickers = new CopyOnWriteArrayList<>();
  private final List<Runnable> closers = new CopyOnWriteArrayList<>();
  private final Map<Integer, List<Taker>> takers = new ConcurrentHashMap<>();
  private final List<Taker> others = new CopyOnWriteArrayList<>();
  private final List<BooleanSupplier> busy = new CopyOnWriteArrayList<>();
  private final Rhythm rhythm = new Rhythm();
  private final AtomicInteger holds = new AtomicInteger();
  private volatile long lingerUntil = System.nanoTime() - LINGER_NANOS; // ticks bring an earlier time than that of
                                                                        // their making
  private volatile String refusal = "";
  private volatile boolean missing;
  private Optional<Subscription> subscription = Optional.empty();
  private boolean closed;

  public DeviceFeed(PlayerDevice device, Surroundings around) {
    this.device = device;
    this.around = around;
    Interfaces.furnish(this);
  }

  public PlayerDevice device() {
    return device;
  }

  public String name() {
    return device.name();
  }

  Surroundings around() {
    return around;
  }

  // What the interfaces furnish a device with; all of it before it is first ticked.

  <D extends Data> Outlet<D> outlet(String suffix, Class<D> type, String help) {
    Outlet<D> outlet = new Outlet<>(around.context(), name() + suffix, type, name() + ": " + help);
    outlets.add(outlet);
    return outlet;
  }

  void drop(Outlet<?> outlet) {
    outlets.remove(outlet);
    outlet.close();
  }

  <T> void on(Kind.Data<T> kind, Outlet<?> outlet, BiConsumer<T, Reception> action) {
    Codec<T> codec = around.layouts().codec(kind);
    on(around.layouts().message(kind).subtype(), outlet, (m, r) -> action.accept(codec.decode(m.payload()), r));
  }

  /** All data of one number as records; of an interface that is not known, all data at all. */
  void records(String suffix, Optional<MessageLayout> layout) {
    String help = layout.map(MessageLayout::comment).filter(c -> !c.isEmpty()).orElse("as the device says it");
    Outlet<DynamicRecord> outlet = outlet(suffix, DynamicRecord.class, help);
    Taker taker = (m, r) -> outlet.publish(around.record(m), r);
    layout.ifPresentOrElse(l -> on(l.subtype(), outlet, taker), () -> others.add(guarded(outlet, taker)));
  }

  boolean listensTo(int subtype) {
    return takers.containsKey(subtype);
  }

  private void on(int subtype, Outlet<?> outlet, Taker taker) {
    takers.computeIfAbsent(subtype, s -> new CopyOnWriteArrayList<>()).add(guarded(outlet, taker));
  }

  private Taker guarded(Outlet<?> outlet, Taker taker) {
    return (m, r) -> {
      try {
        taker.take(m, r);
      } catch (PlayerException | IllegalArgumentException | ArithmeticException e) {
        outlet.lost(name() + " at " + around.peer() + ": " + e.getMessage());
      }
    };
  }

  <D extends Data> void command(String suffix, Class<D> type, String help, CommandSink<D> sink) {
    commands.add(around.context().offers()
        .command(new CommandPort<>(name() + suffix, type, Arity.MANY, name() + ": " + help), sink));
  }

  void onOpen(Runnable opener) {
    openers.add(opener);
  }

  /** Before anything is sent to a device that is open anew. */
  void onLost(Runnable loser) {
    losers.add(loser);
  }

  /** It is not closed while this is so, not even to be opened again. */
  void whileBusy(BooleanSupplier moving) {
    busy.add(moving);
  }

  void onTick(LongConsumer ticker) {
    tickers.add(ticker);
  }

  void onClose(Runnable closer) {
    closers.add(closer);
  }

  <A> void ask(Kind.Request<Empty, A> kind, Consumer<A> answered, Consumer<String> otherwise) {
    ask(kind, new Empty(), answered, otherwise);
  }

  /** Asks the device; what is done with the answer must not block, and its mistakes are the device's. */
  <Q, A> void ask(Kind.Request<Q, A> kind, Q question, Consumer<A> answered, Consumer<String> otherwise) {
    device.request(kind, question).thenAccept(outcome -> {
      if (outcome instanceof Outcome.Done<A> done) {
        try {
          answered.accept(done.value());
        } catch (IllegalArgumentException | ArithmeticException e) {
          otherwise.accept(kind.message() + " of " + name() + ": " + e.getMessage());
        }
      } else {
        otherwise.accept(outcome.reason());
      }
    });
  }

  // What became silent.

  /** Whether its data are wanted and came regularly, be it until now or until they stopped. */
  public boolean isRegular() {
    return wanted() && rhythm.isKnown() && MEASURING.contains(name().substring(0, name().indexOf(':')))
        && device.state() instanceof DeviceState.Open open && !open.driver().contains(LOCALISATION);
  }

  /** Whether regular data have stopped. */
  public boolean isSilent(long nowNanos) {
    return rhythm.isSilent(nowNanos) && busy.stream().noneMatch(BooleanSupplier::getAsBoolean);
  }

  /** Asks for its data again. */
  public void reopen(long nowNanos) {
    LOG.info("{} at {} sends nothing any more while others do: it is opened again", name(), around.peer());
    rhythm.retried(nowNanos);
    device.reopen();
  }

  // The subscription.

  /** Whether the device is open. */
  public boolean open() {
    return device.state() instanceof DeviceState.Open;
  }

  /** Keeps the device open for a while, since somebody commands it. */
  public void linger() {
    lingerUntil = System.nanoTime() + LINGER_NANOS;
    apply(System.nanoTime());
  }

  /** Keeps the device open until it is closed. */
  public Offer hold() {
    holds.incrementAndGet();
    apply(System.nanoTime());
    return holds::decrementAndGet;
  }

  /** Whether a view looks at it. */
  public boolean wanted() {
    return outlets.stream().anyMatch(Outlet::wanted);
  }

  /** Whether a view looks at what only says something to those who know where the robot is. */
  public boolean placedAndWanted() {
    return outlets.stream().anyMatch(o -> o.placed() && o.wanted());
  }

  /** Acts on what is wanted now. */
  public void tick(long nowNanos) {
    apply(nowNanos);
    if (open()) {
      tickers.forEach(t -> t.accept(nowNanos));
    }
  }

  private synchronized void apply(long nowNanos) {
    boolean needed = !closed && (wanted() || holds.get() > 0 || nowNanos - lingerUntil < 0 || around.carries(name()));
    if (needed && subscription.isEmpty()) {
      subscription = Optional.of(device.subscribe(new Hearing()));
    } else if (!needed && subscription.isPresent()) {
      subscription.get().close();
      subscription = Optional.empty();
      refusal = "";
    }
  }

  private final class Hearing implements DeviceListener {
    @Override
    public void onData(PlayerMessage message, long receiveNanos) {
      around.pulse().heard(receiveNanos);
      rhythm.heard(receiveNanos);
      Reception reception = new Reception(around.stamps().of(message.stamp()), receiveNanos, Optional.of(raw(message)));
      List<Taker> taking = takers.getOrDefault(message.subtype(), others);
      if (taking.isEmpty()) {
        outlets.stream().findFirst().ifPresent(
            o -> o.lost(name() + " at " + around.peer() + ": data " + message.subtype() + " are not known here"));
      }
      taking.forEach(taker -> take(taker, message, reception));
    }

    @Override
    public void onState(DeviceState state) {
      String before = refusal;
      refusal = state instanceof DeviceState.Refused refused ? refused.reason() : "";
      if (!refusal.equals(before)) {
        outlets.forEach(o -> o.failed(refusal));
      }
      if (state instanceof DeviceState.Open) {
        openers.forEach(Runnable::run);
      } else {
        rhythm.forget();
        losers.forEach(Runnable::run);
      }
    }
  }

  private static void take(Taker taker, PlayerMessage message, Reception reception) {
    try {
      taker.take(message, reception);
    } catch (PlayerException e) {
      throw new IllegalStateException("takers tell of their mistakes themselves", e);
    }
  }

  private RawMessage raw(PlayerMessage message) {
    ByteBuffer payload = message.payload();
    return new RawMessage(around.schema(message), Surroundings.ENCODING, Bytes.wrap(payload), bytes -> read(message),
        new RawOrigin(name(), around.peer(), false, () -> around.definition(message)));
  }

  private Optional<DynamicRecord> read(PlayerMessage message) {
    try {
      return Optional.of(around.record(message));
    } catch (PlayerException e) {
      return Optional.empty();
    }
  }

  /** Whether the server has it; tells whoever looks at it. */
  public void present(boolean now) {
    if (missing == now) {
      missing = !now;
      String reason = missing ? around.peer() + " has no " + name() + " any more" : "";
      outlets.forEach(o -> o.failed(reason));
    }
  }

  /** What is wanted but does not work; empty where all is well. */
  public String problem() {
    return missing && wanted() ? "the server has no " + name() + " any more" : refusal;
  }

  /** Its data by their layouts, for those who browse. */
  public List<MessageLayout> messages(MessageType type) {
    return around.layouts().byCode(device.id().interfaceCode())
        .map(i -> i.messages().stream().filter(m -> m.type() == type).toList()).orElse(List.of());
  }

  /** Stops what was commanded here, withdraws the ports and tells the server that nobody listens any more. */
  @Override
  public void close() {
    closers.forEach(Runnable::run);
    synchronized (this) {
      closed = true;
    }
    new ArrayList<>(commands).forEach(Offer::close);
    apply(System.nanoTime());
    outlets.forEach(Outlet::close);
  }
}
