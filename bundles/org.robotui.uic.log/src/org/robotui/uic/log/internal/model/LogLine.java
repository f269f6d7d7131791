package org.robotui.uic.log.internal.model;

/**
 * A row of the list: an entry, or several alike in a row.
 *
 * @param first the entry that began the row; its id is that of the row
 * @param last the newest of those alike, the same as the first where it is alone
 * @param count how many they are
 */
public record LogLine(Entry first, Entry last, int count) {
  /** A row of one entry. */
  public static LogLine of(Entry entry) {
    return new LogLine(entry, entry, 1);
  }

  /** The row with one more of the same. */
  public LogLine and(Entry another) {
    return new LogLine(first, another, count + 1);
  }

  /** What identifies the row while it grows. */
  public long id() {
    return first.id();
  }
}
