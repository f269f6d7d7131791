package org.robotui.player.internal.client;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import org.robotui.net.call.Outcome;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerMessage;

/**
 * Requests whose answers did not come yet. The server's own answers repeat the number of the request; those of drivers
 * do not, and are taken for the oldest request of that device and kind.
 */
final class Requests {

  private record Waiting(DeviceId device, int subtype, long sequence, String name, long deadline, Duration patience,
      CompletableFuture<Outcome<PlayerMessage>> answer) {

    boolean isAnsweredBy(PlayerMessage message) {
      return device.equals(message.device().id()) && subtype == message.subtype()
          && (device.interfaceCode() != DeviceAddress.SERVER || sequence == message.sequence());
    }
  }

  private final String peer;
  private final int most;
  private final List<Waiting> waiting = new ArrayList<>();
  private Optional<String> lost = Optional.empty();

  Requests(String peer, int most) {
    this.peer = peer;
    this.most = most;
  }

  /** Waits for the answer to a request that is about to be sent. */
  synchronized CompletableFuture<Outcome<PlayerMessage>> add(PlayerMessage request, String name, Duration patience) {
    CompletableFuture<Outcome<PlayerMessage>> answer = new CompletableFuture<>();
    if (lost.isPresent()) {
      answer.complete(new Outcome.Failed<>(lost.get()));
    } else if (waiting.size() >= most) {
      answer.complete(
          new Outcome.Failed<>(name + " at " + peer + ": " + most + " requests wait for their answers already"));
    } else {
      waiting.add(new Waiting(request.device().id(), request.subtype(), request.sequence(), name,
          System.nanoTime() + patience.toNanos(),
          patience, answer));
    }
    return answer;
  }

  /** Takes an answer; false if nobody waits for it. */
  boolean answer(PlayerMessage message) {
    List<Waiting> found = remove(each -> each.isAnsweredBy(message), 1);
    found.forEach(each -> each.answer.complete(message.type() == MessageType.ACK ? new Outcome.Done<>(message)
        : new Outcome.Refused<>(each.name + " at " + peer + " is refused by the device")));
    return !found.isEmpty();
  }

  /** Ends those that waited too long. */
  void expire(long now) {
    remove(each -> each.deadline - now <= 0, Integer.MAX_VALUE)
        .forEach(each -> each.answer.complete(new Outcome.TimedOut<>(
            each.name + " at " + peer + ": no answer within " + each.patience.toMillis() + " ms", each.patience)));
  }

  /** Ends all, and those that come later at once. */
  void fail(String reason) {
    synchronized (this) {
      lost = Optional.of(reason);
    }
    remove(each -> true, Integer.MAX_VALUE).forEach(each -> each.answer.complete(new Outcome.Failed<>(reason)));
  }

  /** When the next one ends, by {@link System#nanoTime}; the given time if none does before. */
  synchronized long nextDeadline(long latest) {
    return waiting.stream().mapToLong(Waiting::deadline).reduce(latest, (a, b) -> a - b < 0 ? a : b);
  }

  private synchronized List<Waiting> remove(Predicate<Waiting> which, int limit) {
    List<Waiting> removed = new ArrayList<>();
    for (Iterator<Waiting> each = waiting.iterator(); each.hasNext() && removed.size() < limit;) {
      Waiting next = each.next();
      if (which.test(next)) {
        removed.add(next);
        each.remove();
      }
    }
    return removed;
  }
}
