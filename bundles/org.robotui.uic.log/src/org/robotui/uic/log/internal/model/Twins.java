package org.robotui.uic.log.internal.model;

import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/**
 * Recognises what a robot says twice, on two ports, as where one repeats what comes on others. An entry of a second
 * source is a twin where another source gave the same (stamp, origin, severity, message) within two seconds; what one
 * source itself repeats is no twin. One thread.
 */
final class Twins {
  static final int MOST = 20_000;
  static final long WITHIN_NANOS = 2_000_000_000L;

  // Of the message only length and hash are held: a robot cannot fill the memory with long ones here.
  private record Key(long stamp, String origin, Severity severity, int length, int hash) {}

  private static final class Seen {
    private final long since;
    private final Map<SourceId, Integer> perSource = new HashMap<>(4);
    private int shown;

    Seen(long since) {
      this.since = since;
    }
  }

  private final Map<Key, Seen> seen = new LinkedHashMap<>();
  private long newest = Long.MIN_VALUE / 2;

  /** Whether another source gave this entry already. */
  boolean isTwin(Envelope<LogEntry> envelope, String origin) {
    long received = envelope.receivedNanos();
    newest = Math.max(newest, received);
    LogEntry e = envelope.value();
    Key key = new Key(envelope.stamp().map(s -> s.nanos()).orElse(0L), origin, e.severity(), e.message().length(),
        e.message().hashCode());
    Seen known = seen.compute(key,
        (k, old) -> old == null || Math.abs(received - old.since) > WITHIN_NANOS ? new Seen(received) : old);
    int ofThisSource = known.perSource.merge(envelope.source(), 1, Integer::sum);
    if (seen.size() > MOST) {
      forget(MOST, Long.MIN_VALUE);
    }
    boolean twin = ofThisSource <= known.shown;
    known.shown = Math.max(known.shown, ofThisSource);
    return twin;
  }

  int size() {
    return seen.size();
  }

  /**
   * Forgets what is too old to have twins. To be called between drains: in one drain sources may come one after the
   * other, each with all it has.
   */
  void settle() {
    forget(MOST, newest - WITHIN_NANOS);
  }

  private void forget(int most, long before) {
    Iterator<Seen> oldest = seen.values().iterator();
    while (oldest.hasNext() && (oldest.next().since < before || seen.size() > most)) {
      oldest.remove();
    }
  }
}
