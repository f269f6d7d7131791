package org.robotui.lcm.internal.udpm;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.internal.client.Counters;

/**
 * Puts messages together, from several senders at once, within bounds of memory and time: the oldest is given up first.
 */
final class Reassembly {

  private static final int MOST_MESSAGES = 256;

  private final Counters counters;
  private final int maxMessageBytes;
  private final long maxBytes;
  private final long patience;
  private final Map<Key, Partial> partials = new LinkedHashMap<>();
  private long held;

  Reassembly(Counters counters, LcmOptions options) {
    this.counters = counters;
    this.maxMessageBytes = options.maxMessageBytes();
    this.maxBytes = options.partialBytes();
    this.patience = options.partialTime().toNanos();
  }

  /** Which message a fragment belongs to. */
  record Key(InetSocketAddress from, int sequence) {}

  boolean knows(Key key) {
    return partials.containsKey(key);
  }

  /** Adds a fragment; answers the message if it was the last one. */
  Optional<Partial> add(Key key, Fragment fragment, ByteBuffer data, Optional<String> channel, boolean wanted, long now)
      throws DatagramException {
    if (fragment.size() > maxMessageBytes) {
      throw new DatagramException(
          "a message of " + fragment.size() + " bytes" + channel.map(name -> " on " + name).orElse("")
              + ", at most " + maxMessageBytes + " are accepted");
    }
    Partial partial = partials.get(key);
    if (partial != null && !partial.isOf(fragment)) {
      giveUp(key); // another message with the same number: its sender was started anew
      partial = null;
    }
    if (partial == null) {
      partial = new Partial(fragment);
      partials.put(key, partial);
    }
    return grown(key, partial, fragment, data, channel, wanted, now);
  }

  private Optional<Partial> grown(Key key, Partial partial, Fragment fragment, ByteBuffer data,
      Optional<String> channel, boolean wanted, long now)
      throws DatagramException {
    held -= partial.held();
    try {
      channel.ifPresent(name -> partial.named(name, wanted));
      partial.add(fragment, data, now);
    } catch (DatagramException e) {
      partials.remove(key);
      throw e;
    }
    if (partial.isComplete()) {
      partials.remove(key);
      return Optional.of(partial);
    }
    held += partial.held();
    keepBounds();
    return Optional.empty();
  }

  private void keepBounds() {
    while (partials.size() > MOST_MESSAGES || held > maxBytes) {
      giveUp(partials.keySet().iterator().next());
    }
  }

  private void giveUp(Key key) {
    held -= partials.remove(key).held();
    counters.incomplete();
  }

  /** Gives up messages whose next fragment is late. */
  void expire(long now) {
    for (Iterator<Partial> each = partials.values().iterator(); each.hasNext();) {
      Partial partial = each.next();
      if (now - partial.last() < patience) {
        return; // those that began later are looked at when it is their turn
      }
      held -= partial.held();
      counters.incomplete();
      each.remove();
    }
  }

  /** How much memory is held. */
  long held() {
    return held;
  }
}
