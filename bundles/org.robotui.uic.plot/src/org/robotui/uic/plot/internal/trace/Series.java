package org.robotui.uic.plot.internal.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The samples of one trace in the order of time, in bounded memory: the oldest are forgotten a chunk at a time. What is
 * asked costs as much as the screen has columns, not as much as there are samples. Safe for all threads.
 */
public final class Series {
  private final int mostChunks;
  private final List<Chunk> chunks = new ArrayList<>();
  private long added;

  /** Keeps at least so many samples, and at most two chunks more. */
  public Series(long samples) {
    this.mostChunks = Math.toIntExact((samples + Chunk.SIZE - 1) / Chunk.SIZE + 1);
  }

  /**
   * Adds a sample.
   *
   * @param time nanoseconds, not before the newest
   * @param value NaN breaks the line
   */
  public synchronized void add(long time, double value) {
    if (!chunks.isEmpty() && time < lastTime()) {
      throw new IllegalArgumentException(
          "samples of a series come in the order of time: " + time + " after " + lastTime());
    }
    if (chunks.isEmpty() || chunks.getLast().isFull()) {
      chunks.add(new Chunk());
    }
    chunks.getLast().add(time, value);
    added++;
    if (chunks.size() > mostChunks) {
      chunks.removeFirst();
    }
  }

  public synchronized void clear() {
    chunks.clear();
    added++;
  }

  /** Changes with every change. */
  public synchronized long version() {
    return added;
  }

  public synchronized int size() {
    return chunks.isEmpty() ? 0 : (chunks.size() - 1) * Chunk.SIZE + chunks.getLast().count();
  }

  public synchronized Samples samples() {
    return new Samples(chunks, size());
  }

  /** From the first sample to the last; none where it is empty. */
  public synchronized Optional<TimeSpan> extent() {
    return chunks.isEmpty() ? Optional.empty() : Optional.of(new TimeSpan(chunks.getFirst().time(0), lastTime()));
  }

  /** What the samples within a span are together. */
  public synchronized void summarize(TimeSpan span, Summary summary) {
    summarize(indexOf(span.from()), indexOf(span.to() + 1), summary);
  }

  /** The same for users to read. */
  public synchronized Statistics statistics(TimeSpan span) {
    int from = skip(indexOf(span.from()), 1);
    int to = skip(indexOf(span.to() + 1) - 1, -1);
    Summary all = new Summary();
    if (from <= to) {
      summarize(from, to + 1, all);
    }
    return Statistics.of(all, from < to ? time(to) - time(from) : 0);
  }

  /** The sample nearest to a time within a distance; breaks do not count. */
  public synchronized Optional<Sample> nearest(long time, long within) {
    int after = skip(indexOf(time), 1);
    int before = skip(indexOf(time) - 1, -1);
    OptionalInt best = nearer(time, before, after);
    return best.isPresent() && Math.abs(time(best.getAsInt()) - time) <= within
        ? Optional.of(new Sample(time(best.getAsInt()), value(best.getAsInt())))
        : Optional.empty();
  }

  /** The newest sample at or before a time that is a number. */
  public synchronized Optional<Sample> lastUntil(long time) {
    int last = skip(indexOf(time + 1) - 1, -1);
    return last < 0 ? Optional.empty() : Optional.of(new Sample(time(last), value(last)));
  }

  /** The newest sample that is a number. */
  public synchronized Optional<Sample> newest() {
    int last = skip(size() - 1, -1);
    return last < 0 ? Optional.empty() : Optional.of(new Sample(time(last), value(last)));
  }

  /**
   * Draws the samples of a span for a screen: all of them where they are few, and one beyond each end, so that lines
   * leave the screen; else of each column the first, the smallest, the largest and the last. Columns lie on a grid that
   * does not move with the span, so that what scrolls does not shimmer.
   *
   * @param span what is seen
   * @param columns how many can be told apart, at least 1
   * @param sketch is cleared and filled
   */
  public synchronized void sketch(TimeSpan span, int columns, Sketch sketch) {
    sketch.clear();
    int from = Math.max(0, indexOf(span.from()) - 1);
    int to = Math.min(size(), indexOf(span.to() + 1) + 1);
    if (to - from <= 2L * columns) {
      for (int i = from; i < to; i++) {
        sketch.add(time(i), value(i));
      }
    } else {
      sketchColumns(from, to, Math.max(1, Math.ceilDiv(span.length(), (long) columns)), sketch);
    }
  }

  private void sketchColumns(int from, int to, long width, Sketch sketch) {
    sketch.dense();
    Summary summary = new Summary();
    int at = from;
    int usual = 1;
    while (at < to) {
      long column = Math.floorDiv(time(at), width);
      int end = Math.max(at + 1, Math.min(to, indexNear(at + usual, (column + 1) * width)));
      usual = end - at;
      summary.clear();
      summarize(at, end, summary);
      sketch.column(time(at), value(at), column * width + width / 2, summary, time(end - 1), value(end - 1));
      at = end;
    }
  }

  void summarize(int from, int to, Summary summary) {
    int at = from;
    while (at < to) {
      int start = at % Chunk.SIZE;
      int end = Math.min(Chunk.SIZE, start + to - at);
      chunks.get(at / Chunk.SIZE).summarize(start, end, summary);
      at += end - start;
    }
  }

  private OptionalInt nearer(long time, int before, int after) {
    if (before < 0) {
      return after < size() ? OptionalInt.of(after) : OptionalInt.empty();
    }
    return OptionalInt.of(after < size() && time(after) - time < time - time(before) ? after : before);
  }

  private int skip(int index, int step) {
    int at = index;
    while (at >= 0 && at < size() && !Double.isFinite(value(at))) {
      at += step;
    }
    return at;
  }

  private long lastTime() {
    Chunk last = chunks.getLast();
    return last.time(last.count() - 1);
  }

  long time(int index) {
    return chunks.get(index / Chunk.SIZE).time(index % Chunk.SIZE);
  }

  double value(int index) {
    return chunks.get(index / Chunk.SIZE).value(index % Chunk.SIZE);
  }

  /** As {@link #indexOf}, faster where a guess is right or wrong by one. */
  private int indexNear(int guess, long time) {
    for (int i = guess - 1; i <= guess + 1; i++) {
      if (i > 0 && i < size() && time(i - 1) < time && time(i) >= time) {
        return i;
      }
    }
    return indexOf(time);
  }

  int indexOf(long time) {
    int low = 0;
    int high = chunks.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (chunks.get(middle).time(0) < time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return chunks.isEmpty() ? 0 : low * Chunk.SIZE + chunks.get(low).indexOf(time);
  }
}
