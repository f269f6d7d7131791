package org.robotui.rtps.internal.endpoint;

import java.util.BitSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.internal.wire.SequenceSet;

/** Sends changes, whole or in fragments, and again what was asked for. Its writer's lock guards it. */
final class Sending {

  /** In one turn no reader gets more again, so that its buffers take it and others get theirs. */
  private static final long TURN = PacedChanges.TURN / 2;

  private final EntityId writer;
  private long repaired;

  Sending(EntityId writer) {
    this.writer = writer;
  }

  /** Sends a change whole; answers its bytes. */
  long change(EndpointOutlet.Batch batch, EntityId reader, Destination to, Change change) {
    some(batch, new SendTarget(to, reader, false), change, 1, Long.MAX_VALUE);
    return change.size();
  }

  /**
   * Sends so many bytes of a change from a fragment on, at least one; answers the next fragment, or 0 after the last.
   */
  long some(EndpointOutlet.Batch batch, SendTarget target, Change change, long from, long most) {
    int fragmentSize = target.destination().fragmentSize();
    if (change.size() <= fragmentSize) {
      batch.data(target.reader(), writer, change);
      return 0;
    }
    long count = count(change, target.destination());
    long sent = 0;
    long number = from;
    for (; number <= count && (sent == 0 || sent + fragmentSize <= most); number++) {
      batch.fragment(target.reader(), writer, change, fragmentSize, number);
      sent += fragmentSize;
    }
    return number <= count ? number : 0;
  }

  /** How many fragments a change has. */
  static long count(Change change, Destination to) {
    return (change.size() + to.fragmentSize() - 1) / to.fragmentSize();
  }

  /** Sends some of what a reader asked for, and what it asked for in vain as a gap. */
  void repair(EndpointOutlet.Batch batch, RemoteReader reader, ChangeCache cache) {
    long left = TURN;
    Iterator<Long> whole = reader.requested().iterator();
    while (whole.hasNext() && left > 0) {
      long sequence = whole.next();
      whole.remove();
      reader.fragments().remove(sequence);
      left -= whole(batch, reader, cache, sequence);
    }
    Iterator<Map.Entry<Long, BitSet>> partly = reader.fragments().entrySet().iterator();
    while (partly.hasNext() && left > 0) {
      Map.Entry<Long, BitSet> entry = partly.next();
      left -= partly(batch, reader, cache.get(entry.getKey()), entry.getKey(), entry.getValue(), left);
      if (entry.getValue().isEmpty()) {
        partly.remove();
      }
    }
  }

  private long whole(EndpointOutlet.Batch batch, RemoteReader reader, ChangeCache cache, long sequence) {
    Optional<Change> change = cache.get(sequence).filter(kept -> sequence >= reader.start());
    EntityId to = reader.info().guid().entity();
    if (change.isEmpty()) {
      batch.gap(to, writer, sequence, SequenceSet.none(sequence + 1));
      return 0;
    }
    repaired++;
    return change(batch, to, reader.destination(), change.get());
  }

  private long partly(EndpointOutlet.Batch batch, RemoteReader reader, Optional<Change> change, long sequence,
      BitSet numbers,
      long left) {
    EntityId to = reader.info().guid().entity();
    if (change.isEmpty()) {
      batch.gap(to, writer, sequence, SequenceSet.none(sequence + 1));
      numbers.clear();
      return 0;
    }
    long sent = 0;
    int size = reader.destination().fragmentSize();
    for (int number = numbers.nextSetBit(0); number >= 0 && sent < left; number = numbers.nextSetBit(number + 1)) {
      batch.fragment(to, writer, change.get(), size, number);
      numbers.clear(number);
      repaired++;
      sent += size;
    }
    return sent;
  }

  /** The changes and fragments that were sent again. */
  long repaired() {
    return repaired;
  }
}
