package org.robotui.core.internal.port;

import java.util.function.Consumer;
import org.robotui.api.port.Envelope;
import org.robotui.data.Data;

/** Holds what one consumer has not taken yet. Offering never blocks; one thread at a time drains. */
interface Mailbox<T extends Data> {
  void offer(Envelope<T> envelope);

  int drain(Consumer<? super Envelope<T>> consumer);

  long dropped();
}
