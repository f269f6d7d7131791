package org.robotui.core.internal.port;

import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** How one consumer takes what came since it took last. One thread at a time drains; any thread closes. */
interface TapReader<T extends Data> extends AutoCloseable {
  int drain(Consumer<? super Envelope<T>> consumer);

  /** Values lost to a full queue, and keys given up, for this consumer. */
  long dropped();

  @Override
  void close();
}
