package org.robotui.lcm.internal.udpm;

import java.util.ArrayList;
import java.util.List;

/**
 * Counts the messages that are missing between those that came from one address. Several senders may share an address
 * (the Java client sends from the group's own port), and count their messages each for itself.
 */
final class SequenceWatch {

  private static final int MOST_STREAMS = 8;
  /** A number further ahead is that of another sender. */
  private static final int FARTHEST = 1 << 20;
  private static final int WINDOW = Long.SIZE;

  private final List<Stream> streams = new ArrayList<>();

  /** The numbers of one sender: the last one, and which of those before it came. */
  private static final class Stream {

    private int last;
    /** What was before the first one is nobody's loss. */
    private long seen = -1;

    Stream(int first) {
      last = first;
    }

    int ahead(int sequence) {
      return sequence - last;
    }

    long advance(int steps) {
      last += steps;
      seen = steps < WINDOW ? seen << steps | 1 : 1;
      return steps - 1L;
    }

    /** A late one was counted as lost before. */
    long late(int back) {
      long bit = 1L << back;
      boolean missing = (seen & bit) == 0;
      seen |= bit;
      return missing ? -1 : 0;
    }

    boolean hasWithin(int back) {
      return back >= 0 && back < WINDOW;
    }
  }

  /** Notes a message; answers how many more are missing than before. */
  long heard(int sequence) {
    Stream next = null;
    for (Stream each : streams) {
      int ahead = each.ahead(sequence);
      if (ahead > 0 && ahead <= FARTHEST && (next == null || ahead < next.ahead(sequence))) {
        next = each;
      }
    }
    if (next != null
        && (next.ahead(sequence) == 1 || streams.stream().noneMatch(each -> each.hasWithin(-each.ahead(sequence))))) {
      return next.advance(next.ahead(sequence));
    }
    for (Stream each : streams) {
      if (each.hasWithin(-each.ahead(sequence))) {
        return each.late(-each.ahead(sequence));
      }
    }
    if (streams.size() == MOST_STREAMS) {
      streams.removeFirst();
    }
    streams.add(new Stream(sequence));
    return 0;
  }
}
