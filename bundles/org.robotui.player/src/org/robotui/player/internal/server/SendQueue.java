package org.robotui.player.internal.server;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.player.interfaces.Server;
import org.robotui.player.wire.PlayerMessage;

/**
 * What waits for one client: answers always, data as the client wants them. When too many data wait the oldest go, and
 * are counted.
 */
final class SendQueue {

  /** Answers that nobody reads: the client is stopped or hostile. */
  private static final int MOST_ANSWERS = 1024;

  private final int mostData;
  private final ReplaceRules rules = new ReplaceRules();
  private final ArrayDeque<PlayerMessage> answers = new ArrayDeque<>();
  private final ArrayDeque<PlayerMessage> data = new ArrayDeque<>();
  /** Of the data, how many may be sent; the others wait until they are fetched. */
  private int released;
  private Optional<PlayerMessage> mark = Optional.empty();
  private long dropped;
  private boolean pull;
  private boolean writing;
  private boolean closed;

  SendQueue(int mostData) {
    this.mostData = mostData;
  }

  /** Adds an answer; false if too many wait. */
  synchronized boolean answer(PlayerMessage message) {
    answers.add(message);
    notifyAll();
    return answers.size() <= MOST_ANSWERS;
  }

  synchronized void data(PlayerMessage message) {
    ReplaceRules.Verdict verdict = rules.of(message);
    if (verdict == ReplaceRules.Verdict.IGNORE || closed) {
      return;
    }
    if (verdict == ReplaceRules.Verdict.REPLACE) {
      remove(data.stream().skip(pull ? released : 0).filter(older -> isSame(older, message)).findFirst());
    }
    if (data.size() >= mostData) {
      remove(Optional.of(data.peek()));
      dropped++;
    }
    data.add(message);
    released += pull ? 0 : 1;
    notifyAll();
  }

  private void remove(Optional<PlayerMessage> older) {
    older.ifPresent(message -> {
      // a message is itself only: others may carry the same
      int at = 0;
      for (PlayerMessage each : data) {
        if (each == message) {
          break;
        }
        at++;
      }
      data.removeIf(each -> each == message);
      released -= at < released ? 1 : 0;
    });
  }

  private static boolean isSame(PlayerMessage older, PlayerMessage newer) {
    return older.subtype() == newer.subtype() && older.device().equals(newer.device());
  }

  /** Adds a rule; false if it is not taken. */
  synchronized boolean rule(Server.ReplaceRule rule) {
    return rules.add(rule);
  }

  /** Whether data wait until they are fetched. */
  synchronized void pull(boolean wanted) {
    pull = wanted;
    released = wanted ? released : data.size();
    notifyAll();
  }

  /** Gives out the answer to a fetch, what waits, and the mark at the end. */
  synchronized boolean fetch(PlayerMessage answer, PlayerMessage end) {
    released = data.size();
    mark = Optional.of(end);
    return answer(answer);
  }

  /** How many data were dropped since this was last asked. */
  synchronized long takeDropped() {
    long count = dropped;
    dropped = 0;
    return count;
  }

  /** Waits for the next message; empty once closed. */
  synchronized Optional<PlayerMessage> take() throws InterruptedException {
    writing = false;
    notifyAll();
    while (isEmpty() && !closed) {
      wait();
    }
    writing = !closed;
    if (closed) {
      return Optional.empty();
    }
    if (!answers.isEmpty()) {
      return Optional.of(answers.remove());
    }
    if (released > 0) {
      released--;
      return Optional.of(data.remove());
    }
    Optional<PlayerMessage> end = mark;
    mark = Optional.empty();
    return end;
  }

  private boolean isEmpty() {
    return answers.isEmpty() && released == 0 && mark.isEmpty();
  }

  /** Waits until nothing waits any more, apart from what is to be fetched; false where it did not come to that. */
  synchronized boolean awaitSent(long deadlineNanos) throws InterruptedException {
    for (long left = deadlineNanos - System.nanoTime(); (writing || !isEmpty()) && !closed; left =
        deadlineNanos - System.nanoTime()) {
      if (left <= 0) {
        return false;
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
    return true;
  }

  synchronized void close() {
    writing = false;
    closed = true;
    notifyAll();
  }
}
