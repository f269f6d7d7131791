package org.robotui.ui.ask;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Health;

/** The questions of one view, newest first. Bounded. Safe for all threads. */
public final class Questions {
  private static final int MOST = 50;

  private final Asker asker;
  private final Deque<Question> all = new ArrayDeque<>();
  private long count;
  private long changes;

  /**
   * No questions yet.
   *
   * @param asker asks them
   */
  public Questions(Asker asker) {
    this.asker = asker;
  }

  /**
   * Asks.
   *
   * @param entry what
   * @param values what was filled in
   */
  public void ask(Catalogue.Entry entry, Map<String, Object> values) {
    Question question = begin(entry);
    Runnable cancel = asker.ask(entry, values, question);
    synchronized (this) {
      question.cancel = cancel;
    }
  }

  private synchronized Question begin(Catalogue.Entry entry) {
    Question question = new Question(count++, entry);
    all.addFirst(question);
    if (all.size() > MOST) {
      all.removeLast();
    }
    changes++;
    return question;
  }

  /**
   * Gives up a question that is still open.
   *
   * @param number its number
   */
  public void cancel(long number) {
    find(number).ifPresent(Runnable::run);
  }

  private synchronized Optional<Runnable> find(long number) {
    return all.stream().filter(q -> q.number == number && q.running).map(q -> q.cancel).findFirst();
  }

  /**
   * What became of them.
   *
   * @return the newest first
   */
  public synchronized List<Asked> asked() {
    return all.stream().map(Question::now).toList();
  }

  /**
   * Counts whatever happens, so that a tick sees whether there is something new.
   *
   * @return the count
   */
  public synchronized long changes() {
    return changes;
  }

  /** One question. */
  private final class Question implements Asker.Report {
    private final long number;
    private final Catalogue.Entry entry;
    private final Instant at = Instant.now();
    private final long started = System.nanoTime();
    private Runnable cancel = () -> {};
    private boolean running = true;
    private Health health = Health.WAITING;
    private String words = "asked";
    private long ended;
    private Optional<DynamicRecord> feedback = Optional.empty();
    private Optional<DynamicRecord> result = Optional.empty();

    Question(long number, Catalogue.Entry entry) {
      this.number = number;
      this.entry = entry;
    }

    @Override
    public void progress(String sentence) {
      change(() -> words = sentence);
    }

    @Override
    public void feedback(DynamicRecord record) {
      change(() -> feedback = Optional.of(record));
    }

    @Override
    public void end(Health how, String sentence, Optional<DynamicRecord> reply) {
      change(() -> {
        health = how;
        words = sentence;
        result = reply;
        ended = System.nanoTime();
        running = false;
      });
    }

    private void change(Runnable change) {
      synchronized (Questions.this) {
        if (running) {
          change.run();
          changes++;
        }
      }
    }

    private Asked now() {
      Duration took = Duration.ofNanos((running ? System.nanoTime() : ended) - started);
      return new Asked(number, entry, at, running, health, words, took, feedback, result);
    }
  }
}
