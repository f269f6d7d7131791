package org.robotui.uic.console.internal.model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * What stands in the console, bounded: the oldest goes first. A script may print faster than it can be shown. Any
 * thread.
 */
public final class Transcript {
  /** Lines that stay. */
  public static final int MOST_LINES = 2000;
  private static final int MOST_LETTERS = 400_000;
  private static final int LONGEST = 20_000;

  private final Deque<ConsoleLine> lines = new ArrayDeque<>();
  private long begin;
  private int letters;

  /**
   * A part of it.
   *
   * @param begin how many lines came before the first that is still kept
   * @param end how many lines have come in all
   * @param lines the newest of them, as far as asked for and kept
   */
  public record Part(long begin, long end, List<ConsoleLine> lines) {
    /** Nothing. */
    public static final Part NONE = new Part(0, 0, List.of());
  }

  /** Adds something. */
  public synchronized void add(ConsoleLine.Kind kind, String text) {
    String kept = text.length() <= LONGEST ? text
        : text.substring(0, LONGEST) + "\n(" + (text.length() - LONGEST) + " more characters)";
    lines.add(new ConsoleLine(kind, kept));
    letters += kept.length();
    while (lines.size() > MOST_LINES || letters > MOST_LETTERS) {
      letters -= lines.remove().text().length();
      begin++;
    }
  }

  /** Forgets all of it. */
  public synchronized void clear() {
    begin += lines.size();
    lines.clear();
    letters = 0;
  }

  /** How many lines have come in all. */
  public synchronized long end() {
    return begin + lines.size();
  }

  /** What came after as many lines, as far as it is still kept. */
  public synchronized Part since(long seen) {
    List<ConsoleLine> all = new ArrayList<>(lines);
    int from = (int) Math.clamp(seen - begin, 0L, all.size());
    return new Part(begin, begin + all.size(), List.copyOf(all.subList(from, all.size())));
  }
}
