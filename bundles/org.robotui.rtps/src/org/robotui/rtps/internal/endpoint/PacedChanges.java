package org.robotui.rtps.internal.endpoint;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Changes that are longer than the buffers of readers may be, and what was written behind them: they go in turns, so
 * that a reader takes one before the next comes. Its writer's lock guards it.
 */
final class PacedChanges {

  /** What a place gets in one turn: a socket of Linux takes some 200 KB where its program asks for nothing else. */
  static final long TURN = 128 << 10;
  /** More does not wait: who writes faster than turns go sends at once. */
  private static final long MOST = 8 << 20;

  private final Sending sending;
  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private long bytes;

  /** What is left of a change for one place: all from a fragment on, counted from 1. */
  private static final class Waiting {
    private final SendTarget target;
    private final Change change;
    private long next = 1;

    Waiting(SendTarget target, Change change) {
      this.target = target;
      this.change = change;
    }
  }

  /** What is done when a change was sent as a whole. */
  @FunctionalInterface
  interface Ending {

    /** The last of a change is in the batch. */
    void sent(EndpointOutlet.Batch batch, SendTarget target);
  }

  PacedChanges(Sending sending) {
    this.sending = sending;
  }

  /** Whether a change has to wait for its turn. */
  boolean applies(Change change) {
    return !waiting.isEmpty() || change.size() > TURN;
  }

  boolean isEmpty() {
    return waiting.isEmpty();
  }

  /** Adds a change; answers whether there is still room for what waits. */
  boolean add(SendTarget target, Change change) {
    waiting.add(new Waiting(target, change));
    bytes += change.size();
    return bytes <= MOST;
  }

  /** Sends what each place takes in one turn, in the order in which it was written. */
  void turn(EndpointOutlet outlet, Ending ending) {
    send(outlet, ending, TURN);
  }

  /** Sends all. */
  void all(EndpointOutlet outlet, Ending ending) {
    send(outlet, ending, Long.MAX_VALUE);
  }

  private void send(EndpointOutlet outlet, Ending ending, long most) {
    Map<Destination, Long> left = new HashMap<>();
    for (Iterator<Waiting> each = waiting.iterator(); each.hasNext();) {
      Waiting next = each.next();
      Destination to = next.target.destination();
      long room = left.getOrDefault(to, most);
      if (room > 0) {
        long sent = send(outlet, ending, next, room);
        left.put(to, next.next == 0 ? room - sent : 0); // nothing overtakes the rest of a change
        if (next.next == 0) {
          each.remove();
          bytes -= next.change.size();
        }
      }
    }
  }

  /** Sends some of a change; answers the bytes that there were of it. */
  private long send(EndpointOutlet outlet, Ending ending, Waiting part, long room) {
    try (EndpointOutlet.Batch batch = outlet.to(part.target.destination())) {
      long before = (part.next - 1) * part.target.destination().fragmentSize();
      part.next = sending.some(batch, part.target, part.change, part.next, room);
      if (part.next == 0) {
        ending.sent(batch, part.target);
      }
      return part.change.size() - before;
    }
  }

  /** Gives up what is for places that are written to no more. */
  void keep(List<SendTarget> targets) {
    Set<Destination> places = new HashSet<>();
    targets.forEach(each -> places.add(each.destination()));
    for (Iterator<Waiting> each = waiting.iterator(); each.hasNext();) {
      Waiting next = each.next();
      if (!places.contains(next.target.destination())) {
        each.remove();
        bytes -= next.change.size();
      }
    }
  }
}
