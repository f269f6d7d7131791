package org.robotui.recording.internal.sqlite;

import java.nio.charset.Charset;
import org.robotui.recording.internal.io.MalformedRecord;

/** The columns of a row, as far as its first bytes are there. */
public final class SqliteValues {

  private static final int MOST_COLUMNS = 64;

  private final byte[] bytes;
  private final int from;
  private final int there;
  private final long[] kinds = new long[MOST_COLUMNS];
  private final long[] places = new long[MOST_COLUMNS];
  private int columns;

  SqliteValues(byte[] bytes, int from, int there, long length) throws MalformedRecord {
    this.bytes = bytes;
    this.from = from;
    this.there = there;
    SqliteNumbers numbers = new SqliteNumbers(bytes, from, from + there);
    long head = numbers.next();
    if (head < 1 || head > there) {
      throw new MalformedRecord("the head of a row has " + head + " bytes");
    }
    long place = head;
    while (numbers.at() - from < head && columns < MOST_COLUMNS) {
      long kind = numbers.next();
      kinds[columns] = kind;
      places[columns++] = place;
      place += size(kind);
      if (kind < 0 || place > length) {
        throw new MalformedRecord("the columns of a row are longer than the row");
      }
    }
  }

  private static long size(long kind) {
    return switch ((int) Math.min(kind, 12)) {
      case 1, 2, 3, 4 -> kind;
      case 5 -> 6;
      case 6, 7 -> 8;
      case 12 -> (kind - 12) / 2;
      default -> 0;
    };
  }

  /** Where a column begins in the bytes of the row. */
  public long place(int column) throws MalformedRecord {
    return places[known(column)];
  }

  /** How many bytes a column has. */
  public long size(int column) throws MalformedRecord {
    return size(kinds[known(column)]);
  }

  private int known(int column) throws MalformedRecord {
    if (column < 0 || column >= columns) {
      throw new MalformedRecord("a row has " + columns + " columns where another one is wanted");
    }
    return column;
  }

  public long whole(int column) throws MalformedRecord {
    long kind = kinds[known(column)];
    if (kind == 8 || kind == 9) {
      return kind - 8;
    }
    if (kind < 1 || kind > 6) {
      throw new MalformedRecord("a column of a row is no whole number");
    }
    int start = start(column);
    long value = bytes[start]; // its sign
    for (int i = 1; i < size(kind); i++) {
      value = value << 8 | bytes[start + i] & 0xff;
    }
    return value;
  }

  /** Empty for one that is missing, as in tables of earlier versions. */
  public String text(int column, Charset charset) throws MalformedRecord {
    if (column < 0 || column >= columns || kinds[column] < 12) {
      return "";
    }
    return new String(bytes, start(column), (int) size(kinds[column]), charset);
  }

  private int start(int column) throws MalformedRecord {
    if (places[column] + size(kinds[column]) > there) {
      throw new MalformedRecord("a column of a row lies outside of its page");
    }
    return from + (int) places[column];
  }
}
