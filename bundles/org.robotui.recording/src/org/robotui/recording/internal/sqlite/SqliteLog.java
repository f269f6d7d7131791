package org.robotui.recording.internal.sqlite;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.io.FileBytes;

/**
 * The write-ahead log beside a database: pages that a recorder which was killed had written, and not moved into the
 * database. Immutable.
 *
 * <p>Source: "WAL-mode File Format" in SQLite's documentation.
 */
final class SqliteLog {

  private static final int MAGIC = 0x377f0682;
  private static final int HEAD = 32;
  private static final int FRAME = 24;
  private static final int MOST_PAGES = 1 << 22;

  private final FileBytes file;
  private final int size;
  private final Map<Long, Long> places;
  private final long pages;

  private SqliteLog(FileBytes file, int size, Map<Long, Long> places, long pages) {
    this.file = file;
    this.size = size;
    this.places = places;
    this.pages = pages;
  }

  /** Empty where nothing in it counts: it is empty, or of an earlier state of the database. */
  static Optional<SqliteLog> read(FileBytes file, int size, DamageList damages) throws RecordingException {
    if (file.size() < HEAD) {
      return Optional.empty();
    }
    ByteBuffer head = ByteBuffer.wrap(file.read(0, HEAD));
    int magic = head.getInt(0);
    if ((magic & ~1) != MAGIC || head.getInt(8) != size) {
      damages.add(0, "the log beside the database (" + file.path().getFileName()
          + ") is none of this database, and was left out");
      return Optional.empty();
    }
    Sum sum = new Sum((magic & 1) == 1 ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    sum.add(head.array(), 0, 24);
    return sum.is(head, 24) ? frames(file, size, head, sum, damages) : Optional.empty();
  }

  /** What counts is what lies before the end of the last whole transaction. */
  private static Optional<SqliteLog> frames(FileBytes file, int size, ByteBuffer head, Sum sum, DamageList damages)
      throws RecordingException {
    Map<Long, Long> committed = new HashMap<>();
    Map<Long, Long> open = new HashMap<>();
    long pages = 0;
    for (long at = HEAD; at + FRAME + size <= file.size(); at += FRAME + size) {
      ByteBuffer frame = ByteBuffer.wrap(file.read(at, FRAME + size));
      sum.add(frame.array(), 0, 8);
      sum.add(frame.array(), FRAME, size);
      if (frame.getLong(8) != head.getLong(16) || !sum.is(frame, 16)) {
        break; // of an earlier round, or not written as a whole
      }
      open.put(frame.getInt(0) & 0xffff_ffffL, at + FRAME);
      if (frame.getInt(4) != 0) {
        committed.putAll(open);
        open.clear();
        pages = frame.getInt(4) & 0xffff_ffffL;
      }
      if (committed.size() + open.size() > MOST_PAGES) {
        damages.add(0, "the log beside the database has more than " + MOST_PAGES + " pages: the rest was left out");
        break;
      }
    }
    return pages == 0 ? Optional.empty() : Optional.of(new SqliteLog(file, size, committed, pages));
  }

  /** How many pages the database has with this. */
  long pages() {
    return pages;
  }

  Optional<byte[]> page(long number) throws RecordingException {
    Long place = places.get(number);
    return place == null ? Optional.empty() : Optional.of(file.read(place, size));
  }

  /** The checksum, which goes on over all frames. */
  private static final class Sum {
    private final ByteOrder order;
    private int first;
    private int second;

    Sum(ByteOrder order) {
      this.order = order;
    }

    void add(byte[] bytes, int from, int length) {
      ByteBuffer words = ByteBuffer.wrap(bytes, from, length).order(order);
      while (words.remaining() >= 8) {
        first += words.getInt() + second;
        second += words.getInt() + first;
      }
    }

    boolean is(ByteBuffer bytes, int at) {
      return bytes.getInt(at) == first && bytes.getInt(at + 4) == second;
    }
  }
}
