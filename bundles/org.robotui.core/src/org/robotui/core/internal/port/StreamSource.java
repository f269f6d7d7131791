package org.robotui.core.internal.port;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.api.replay.StreamHistory;
import org.robotui.core.internal.time.Ageing;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.Late;
import org.robotui.data.Stamp;

/** A stream that a robot interface offers. */
public final class StreamSource<T extends Data> implements Publication<T>, Offered {
  /**
   * How long a loss is told of after values came again, so that a stream of which some are refused is not taken for a
   * sound one.
   */
  private static final long TOLD_NANOS = 5_000_000_000L;
  private static final double SECONDS = 1e-9;

  private final SourceId id;
  private final StreamPort<T> port;
  private final DataType type;
  private final Link link;
  private final NanoClock clock;
  private final Ageing ages;
  private final DemandSwitch demand;
  private final Withdrawal withdrawal;
  private final Fan<T> fan;
  private final AtomicBoolean closed = new AtomicBoolean();
  private final AtomicLong lost = new AtomicLong();
  private volatile Optional<Loss> newestLoss = Optional.empty();
  private volatile Failure failure = Failure.NONE;
  private volatile boolean kept;
  private volatile long newestAt;
  private volatile String delivery = "";
  private volatile Optional<Supplier<List<RawMessage>>> held = Optional.empty();
  private volatile Optional<StreamHistory> history = Optional.empty();

  private record Loss(String reason, long nanos, boolean healed) {}

  /** Why the source as such gives nothing, and since when. */
  private record Failure(String reason, long since) {
    static final Failure NONE = new Failure("", 0);

    boolean isNone() {
      return reason.isEmpty();
    }
  }

  /** Made by the table of offers. */
  public StreamSource(
      SourceId id, StreamPort<T> port, Link link, NanoClock clock, Ageing ages, Demand demand, Executor serial,
      Withdrawal withdrawal) {
    this.id = id;
    this.port = port;
    this.type = port.dataType();
    this.link = link;
    this.clock = clock;
    this.ages = ages;
    this.demand = new DemandSwitch(demand, serial);
    this.withdrawal = withdrawal;
    this.fan = new Fan<>(id, type, ages.nanos());
  }

  @Override
  public void publish(T value, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
    if (!closed.get()) {
      failure = Failure.NONE;
      newestLoss.filter(loss -> !loss.healed())
          .ifPresent(loss -> newestLoss = Optional.of(new Loss(loss.reason(), loss.nanos(), true)));
      long at = ages.at(receivedNanos);
      newestAt = at;
      fan.publish(value, stamp, receivedNanos, raw, at);
    }
  }

  @Override
  public void lost(long count, String reason) {
    lost.addAndGet(count);
    newestLoss = Optional.of(new Loss(reason, clock.nanos(), false));
  }

  @Override
  public void forget() {
    newestLoss = Optional.empty();
    fan.forget();
  }

  @Override
  public void kept(boolean forLateComers) {
    kept = forLateComers;
  }

  @Override
  public void delivery(String promise) {
    delivery = promise;
  }

  @Override
  public void held(Supplier<List<RawMessage>> messages) {
    held = Optional.of(messages);
  }

  @Override
  public void history(StreamHistory all) {
    history = Optional.of(all);
  }

  /** All that a recording has of it. */
  Optional<StreamHistory> history() {
    return history;
  }

  /** The messages that hold now beside the newest one; nothing where it does not consist of messages. */
  public Optional<List<RawMessage>> held() {
    return held.map(Supplier::get).or(() -> fan.hasMessages() ? Optional.of(List.of()) : Optional.empty());
  }

  @Override
  public void failed(String reason) {
    Failure before = failure;
    failure = reason.isEmpty() ? Failure.NONE : new Failure(reason, before.isNone() ? clock.nanos() : before.since());
  }

  /** Adds a consumer: a view, or anything that taps the port without the producer knowing. */
  public Tap<T> join(Intake intake, Runnable filled) {
    demand.add(1);
    return fan.join(intake, filled);
  }

  /** Whether its last value is true until the next one comes, and whoever asks late is given it. */
  boolean holds() {
    return type.late() != Late.NONE && (kept || !type.expires());
  }

  /** Ends a consumer. */
  public void leave(Tap<T> tap) {
    tap.close();
    demand.add(-1);
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      demand.end();
      withdrawal.withdrawn(this);
    }
  }

  /** What a consumer of this source has. */
  InputState state(Tap<T> tap, NanoClock clock) {
    return tap.latest().map(e -> aged(clock.nanos())).orElseGet(this::nothing);
  }

  /** What was received once stays in sight, whatever becomes of its source. */
  private InputState aged(long now) {
    double age = ageSeconds();
    Failure why = failure;
    if (!why.isNone()) {
      return lost(age, why.reason(), why.since(), now);
    }
    return refused().<InputState>map(reason -> InputState.Stale.refused(age, id + ": " + reason))
        .or(() -> stale(age).map(
            late -> link.isUp() ? new InputState.Stale(age, id + ": " + late) : lost(age, late, link.since(), now)))
        .orElseGet(() -> new InputState.Live(fan.rate().rateHz(ages.nanos()), age));
  }

  private double ageSeconds() {
    return (ages.nanos() - newestAt) * SECONDS;
  }

  private InputState lost(double age, String why, long since, long now) {
    return InputState.Stale.lost(age, id + ": " + why, Math.max(0, (now - since) * SECONDS));
  }

  private Optional<String> stale(double age) {
    return Staleness.of(type, kept, age, fan.rate().typicalPeriodSeconds(), link);
  }

  /** Why the newest value is not the newest that was sent, while the link is up. */
  private Optional<String> refused() {
    return newestLoss.filter(loss -> link.isUp() && !loss.healed())
        .map(loss -> "the newest message was refused; " + loss.reason());
  }

  private InputState nothing() {
    Failure why = failure;
    return why.isNone() ? waiting() : new InputState.Failed(id + ": " + why.reason());
  }

  private InputState waiting() {
    String sofar = newestLoss.map(loss -> "nothing usable came yet; " + loss.reason()).orElse("no data yet");
    return new InputState.Waiting(id + ": " + (link.isUp() ? sofar : "no link yet (" + link.text() + ")"));
  }

  /** The newest value, whoever asked for it. */
  public Optional<Envelope<T>> last() {
    return fan.last();
  }

  private Optional<String> told(long now) {
    return newestLoss.filter(loss -> !loss.healed() || now - loss.nanos() < TOLD_NANOS).map(Loss::reason);
  }

  @Override
  public SourceId id() {
    return id;
  }

  @Override
  public StreamPort<T> port() {
    return port;
  }

  @Override
  public PortStatus status(NanoClock clock) {
    Optional<Envelope<T>> last = fan.last();
    long now = clock.nanos();
    double age = last.isPresent() ? ageSeconds() : Double.NaN;
    Optional<String> stale = last.flatMap(e -> stale(age));
    Failure why = failure;
    String problem = !why.isNone() ? why.reason() : told(now).or(() -> stale).orElse("");
    String value = last.map(e -> ValueText.of(e.value())).orElse("");
    return new PortStatus(id, port.kind(), type.name(), demand.wanted(), fan.rate().count(),
        fan.rate().rateHz(ages.nanos()),
        age,
        stale.isPresent() && refused().isEmpty() || !why.isNone() && last.isPresent(), lost.get() + fan.dropped(),
        problem, value, delivery);
  }
}
