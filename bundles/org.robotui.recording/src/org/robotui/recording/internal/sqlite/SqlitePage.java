package org.robotui.recording.internal.sqlite;

import java.nio.ByteBuffer;
import org.robotui.recording.internal.io.MalformedRecord;

/** A page of a table: rows, or the pages below it. */
final class SqlitePage {

  private static final int LEAF = 0x0d;
  private static final int INTERIOR = 0x05;
  private static final int FIRST_HEAD = 100;

  private final ByteBuffer bytes;
  private final int head;
  private final int usable;
  private final int cells;
  private final boolean leaf;

  SqlitePage(byte[] page, long number, int usable) throws MalformedRecord {
    this.bytes = ByteBuffer.wrap(page);
    this.head = number == 1 ? FIRST_HEAD : 0;
    this.usable = usable;
    int kind = page[head] & 0xff;
    if (kind != LEAF && kind != INTERIOR) {
      throw new MalformedRecord("page " + number + " is none of a table");
    }
    this.leaf = kind == LEAF;
    this.cells = bytes.getShort(head + 3) & 0xffff;
    if (pointers() + 2L * cells > usable) {
      throw new MalformedRecord("page " + number + " cannot have " + cells + " entries");
    }
  }

  boolean isLeaf() {
    return leaf;
  }

  int cells() {
    return cells;
  }

  private int pointers() {
    return head + (leaf ? 8 : 12);
  }

  private int cell(int index, int least) throws MalformedRecord {
    int at = bytes.getShort(pointers() + 2 * index) & 0xffff;
    if (at < pointers() || at + least > usable) {
      throw new MalformedRecord("an entry of a page lies outside of it");
    }
    return at;
  }

  /** The page below it, the last one behind all entries. */
  long child(int index) throws MalformedRecord {
    return bytes.getInt(index == cells ? head + 8 : cell(index, Integer.BYTES)) & 0xffff_ffffL;
  }

  SqliteRow row(int index) throws MalformedRecord {
    SqliteNumbers numbers = new SqliteNumbers(bytes.array(), cell(index, 1), usable);
    long length = numbers.next();
    long id = numbers.next();
    if (length < 0) {
      throw new MalformedRecord("a row has " + Long.toUnsignedString(length) + " bytes");
    }
    int local = local(length);
    int from = numbers.at();
    boolean spills = local < length;
    if (from + local + (spills ? Integer.BYTES : 0) > usable) {
      throw new MalformedRecord("a row of " + length + " bytes lies outside of its page");
    }
    return new SqliteRow(bytes.array(), id, length, from, local,
        spills ? bytes.getInt(from + local) & 0xffff_ffffL : 0);
  }

  /** How much of a row lies in its page; the names are those of the documentation. */
  private int local(long length) {
    int x = usable - 35;
    if (length <= x) {
      return (int) length;
    }
    int m = (usable - 12) * 32 / 255 - 23;
    int k = m + (int) ((length - m) % (usable - 4));
    return k <= x ? k : m;
  }
}
