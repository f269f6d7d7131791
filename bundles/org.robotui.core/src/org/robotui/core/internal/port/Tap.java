package org.robotui.core.internal.port;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** One consumer of a source. The source does not know what it is: a view, a recorder, a bridge, a script. */
public final class Tap<T extends Data> implements AutoCloseable {
  private final Fan<T> fan;
  private final TapReader<T> reader;
  private final long since;

  Tap(Fan<T> fan, TapReader<T> reader, long since) {
    this.fan = fan;
    this.reader = reader;
    this.since = since;
  }

  /** The newest value, as far as this consumer may see it. */
  public Optional<Envelope<T>> latest() {
    return fan.last().filter(e -> e.sequence() >= since);
  }

  /** Takes what came since the last call. */
  public int drain(Consumer<? super Envelope<T>> consumer) {
    return reader.drain(consumer);
  }

  /** Values lost to a full queue. */
  public long dropped() {
    return reader.dropped();
  }

  /** Leaves. */
  @Override
  public void close() {
    fan.leave(this);
    reader.close();
  }
}
