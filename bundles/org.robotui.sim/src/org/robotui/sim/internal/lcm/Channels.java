package org.robotui.sim.internal.lcm;

import java.io.IOException;
import java.util.Locale;
import java.util.regex.Pattern;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Sends and receives records; what cannot be sent or read is told seldom. Any thread may use it. */
final class Channels {
  private static final Logger LOG = LoggerFactory.getLogger(Channels.class);
  private static final int QUEUE = 32;
  private static final long SELDOM_NANOS = 10_000_000_000L;

  private final Lcm lcm;
  private final Types types;
  private final String prefix;
  private volatile long told = System.nanoTime() - SELDOM_NANOS;

  /** @param namespace with which the names of all channels begin, empty for none */
  Channels(Lcm lcm, Types types, String namespace) {
    this.lcm = lcm;
    this.types = types;
    prefix = namespace.isEmpty() ? "" : namespace.toUpperCase(Locale.ROOT).replace('/', '_') + "_";
  }

  Types types() {
    return types;
  }

  void send(String channel, LcmRecord record) {
    try {
      lcm.publish(prefix + channel, types.type(record.type().replaceAll(".*\\.", "")).encode(record));
    } catch (IOException e) {
      tell(e.getMessage());
    }
  }

  /** What takes a record. */
  interface Taker {
    void take(LcmRecord record);
  }

  void listen(String channel, String typeName, Taker taker) {
    LcmType type = types.type(typeName);
    lcm.subscribe(Pattern.quote(prefix + channel), SubscriptionOptions.queued(QUEUE), message -> {
      try {
        taker.take(type.decode(message.data()));
      } catch (RecordException e) {
        tell(message.channel() + " from " + message.sender() + " ignored: " + e.getMessage());
      }
    });
  }

  void tell(String problem) {
    long now = System.nanoTime();
    if (now - told >= SELDOM_NANOS) {
      told = now;
      LOG.warn("{}", problem);
    }
  }
}
