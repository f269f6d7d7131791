package org.robotui.recorder.internal.capture;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.host.PortAccess;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Port;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.DataType;
import org.robotui.data.Late;
import org.robotui.data.Stamp;
import org.robotui.data.record.DataRecord;
import org.robotui.recorder.internal.capture.HeadTable.Place;

/** One stream that is recorded. For the thread of its collector. */
final class StreamTap {
  /** Threads that publish at once may swap their numbers; a robot interface that starts anew begins at 0. */
  private static final long SWAPPED = 64;
  private static final long SOON = 20_000_000L;
  private static final long LATE = 160_000_000L;
  /** More in one turn would soon be more than is kept for us. */
  private static final int MANY = 128;

  /**
   * What the streams of a collector share.
   *
   * @param time makes times of the day
   * @param heads the series that were met
   * @param seen the messages that were
   * @param sink takes what is to be written
   */
  record Shared(WallTime time, HeadTable heads, SeenMessages seen, Consumer<Captured> sink) {}

  private final Place place;
  private final PortAccess access;
  private final Shared shared;
  private long expected = -1;
  private long pause = SOON;
  private long due;
  private boolean begun;

  StreamTap(Place place, PortAccess access, Shared shared) {
    this.place = place;
    this.access = access;
    this.shared = shared;
    this.due = System.nanoTime();
  }

  long due() {
    return due;
  }

  /** Takes what came. What comes seldom is looked for less often. */
  void drain(long now) {
    int count = access.take(place.port(), this::taken);
    if (!begun) {
      begun = true;
      access.held(place.port()).ifPresent(held -> held.forEach(this::holds));
    }
    pause = count > MANY ? SOON / 2 : count > 0 ? SOON : Math.min(LATE, pause * 2);
    due = now + pause;
  }

  private void holds(RawMessage message) {
    if (shared.seen().first(message)) {
      long time = shared.time().now();
      shared.sink().accept(new Captured(shared.heads().of(place, message), time, time, 0,
          message.bytes().buffer(ByteOrder.LITTLE_ENDIAN), Optional.of(message.origin().sender())));
    }
  }

  private void taken(Envelope<?> envelope) {
    boolean early = envelope.receivedNanos() - shared.time().startNanos() < 0;
    long gap = gap(envelope.sequence());
    boolean merged = envelope.raw().isEmpty() && access.held(place.port()).isPresent();
    if (merged || early && !holdsOn(envelope) || !envelope.raw().map(shared.seen()::first).orElse(true)) {
      return;
    }
    StreamHead head = shared.heads().of(place, envelope);
    if (gap != 0) {
      head.dropped(gap);
    }
    long logTime = early ? shared.time().startTime() : shared.time().of(envelope.receivedNanos());
    shared.sink().accept(new Captured(head, logTime, published(envelope, logTime), sequence(envelope),
        bytes(envelope), holder(envelope)));
  }

  /** How many were missed before this one; negative where one is made up for. */
  private long gap(long sequence) {
    long missing = expected < 0 ? 0 : sequence - expected;
    boolean swapped = missing < 0 && -missing <= SWAPPED && sequence > 0;
    if (!swapped) {
      expected = sequence + 1;
    }
    return swapped ? -1 : Math.max(0, missing);
  }

  private static long sequence(Envelope<?> envelope) {
    return envelope.sequence() & 0xffff_ffffL;
  }

  private static long published(Envelope<?> envelope, long logTime) {
    return envelope.stamp().map(Stamp::nanos).filter(nanos -> nanos > 0).orElse(logTime);
  }

  private static ByteBuffer bytes(Envelope<?> envelope) {
    return envelope.raw().map(raw -> raw.bytes().buffer(ByteOrder.LITTLE_ENDIAN))
        .orElseGet(() -> DataJson.bytes(DataRecord.of(envelope.value())));
  }

  private Optional<String> holder(Envelope<?> envelope) {
    return envelope.raw().isPresent()
        ? envelope.raw().filter(raw -> raw.origin().kept()).map(raw -> raw.origin().sender())
        : Optional.of("").filter(none -> type().filter(type -> !type.expires()).isPresent());
  }

  /** Whether what was said before the recording is still true in it. */
  private boolean holdsOn(Envelope<?> envelope) {
    return envelope.raw().filter(raw -> raw.origin().kept()).isPresent()
        || type().filter(type -> !type.expires() || type.late() == Late.ALL_KEYS).isPresent();
  }

  private Optional<DataType> type() {
    return access.port(PortKind.STREAM, place.port()).map(StreamTap::type);
  }

  private static DataType type(Port port) {
    return ((StreamPort<?>) port).dataType();
  }
}
