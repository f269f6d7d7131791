package org.robotui.recording.internal.sqlite;

import java.nio.charset.Charset;
import java.util.BitSet;
import java.util.List;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.io.MalformedRecord;

/** A table of a database: its columns, and a way through its rows. What cannot be read is told and left out. */
public final class SqliteTable {

  private static final int DEEPEST = 32;

  private final SqlitePages pages;
  private final DamageList damages;
  private final long root;
  private final List<String> columns;

  SqliteTable(SqlitePages pages, DamageList damages, long root, List<String> columns) {
    this.pages = pages;
    this.damages = damages;
    this.root = root;
    this.columns = columns;
  }

  /** Takes rows. */
  @FunctionalInterface
  public interface Rows {
    /**
     * @param page where the row is
     * @param index which one of that page
     */
    void row(long page, int index, SqliteRow row) throws RecordingException, MalformedRecord;
  }

  /** The place of a column, -1 if there is none. */
  public int column(String name) {
    return columns.indexOf(name);
  }

  public Charset charset() {
    return pages.charset();
  }

  public SqlitePages pages() {
    return pages;
  }

  /** Goes through all rows in their order. */
  public void walk(Rows rows) throws RecordingException {
    walk(root, rows, new BitSet(), DEEPEST);
  }

  private void walk(long number, Rows rows, BitSet seen, int deepest) throws RecordingException {
    try {
      byte[] bytes = pages.page(number);
      if (deepest == 0 || seen.get((int) number)) {
        throw new MalformedRecord("page " + number + " is below itself");
      }
      seen.set((int) number);
      SqlitePage page = new SqlitePage(bytes, number, pages.usable());
      if (page.isLeaf()) {
        rows(page, number, 0, page.cells(), rows);
      } else {
        for (int i = 0; i <= page.cells(); i++) {
          walk(child(page, i, number), rows, seen, deepest - 1);
        }
      }
    } catch (MalformedRecord e) {
      damages.add(pages.place(number), "rows of the database were left out: " + e.getMessage());
    }
  }

  /** Page 0 is none, so that what is wrong with it is told there. */
  private long child(SqlitePage page, int index, long number) {
    try {
      return page.child(index);
    } catch (MalformedRecord e) {
      damages.add(pages.place(number), "an entry of a page was left out: " + e.getMessage());
      return 0;
    }
  }

  /** Goes through some rows of a page. */
  public static void rows(SqlitePages pages, DamageList damages, long number, int from, int to, Rows rows)
      throws RecordingException {
    try {
      SqlitePage page = new SqlitePage(pages.page(number), number, pages.usable());
      new SqliteTable(pages, damages, number, List.of()).rows(page, number, from, Math.min(to, page.cells()), rows);
    } catch (MalformedRecord e) {
      damages.add(pages.place(number), "rows of the database were left out: " + e.getMessage());
    }
  }

  private void rows(SqlitePage page, long number, int from, int to, Rows rows) throws RecordingException {
    for (int i = from; i < to; i++) {
      try {
        rows.row(number, i, page.row(i));
      } catch (MalformedRecord e) {
        damages.add(pages.place(number), "a row of the database was left out: " + e.getMessage());
      }
    }
  }
}
