package org.robotui.roboframe.internal;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.roboframe.wire.BrokerMessage;

/** A value on its way to other applications, which becomes bytes once, and only where one of them wants it. */
public final class Outgoing {
  private final String key;
  private final boolean every;
  private final Supplier<BrokerMessage.Value> making;
  private Optional<BrokerMessage.Value> made = Optional.empty();

  Outgoing(String key, boolean every, Supplier<BrokerMessage.Value> making) {
    this.key = key;
    this.every = every;
    this.making = making;
  }

  public String key() {
    return key;
  }

  public boolean every() {
    return every;
  }

  public synchronized BrokerMessage.Value value() {
    if (made.isEmpty()) {
      made = Optional.of(making.get());
    }
    return made.get();
  }
}
