package org.robotui.recording.internal.rosbag2;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.ChunkSource;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.EntryTable;
import org.robotui.recording.internal.chunk.LoadedChunk;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.sqlite.SqlitePages;
import org.robotui.recording.internal.sqlite.SqliteRow;
import org.robotui.recording.internal.sqlite.SqliteTable;

/** Reads messages out of rows of a database. */
final class DatabaseSource implements ChunkSource {

  private record Place(SqliteRow row, MessageColumns.Found found) {}

  private final FileBytes file;
  private final SqlitePages pages;
  private final MessageColumns columns;
  private final List<RowRange> ranges;
  private final DamageList damages;

  DatabaseSource(FileBytes file, SqlitePages pages, MessageColumns columns, List<RowRange> ranges,
      DamageList damages) {
    this.file = file;
    this.pages = pages;
    this.columns = columns;
    this.ranges = ranges;
    this.damages = damages;
  }

  @Override
  public LoadedChunk load(ChunkRef chunk) throws RecordingException {
    List<Place> rows = rows(ranges.get((int) chunk.offset()));
    EntryTable entries = new EntryTable();
    byte[] bytes = new byte[rows.stream().mapToInt(each -> each.found().length()).reduce(0, Math::addExact)];
    int at = 0;
    for (Place each : rows) {
      try {
        MessageColumns.Found found = each.found();
        each.row().copy(pages, found.start(), bytes, at, found.length());
        entries.add(found.channel(), found.time(), found.time(), 0, at, found.length());
        at += found.length();
      } catch (MalformedRecord e) {
        damages.add(0, "the message in row " + each.row().id() + " was left out: " + e.getMessage());
      }
    }
    return entries.over(bytes);
  }

  private List<Place> rows(RowRange range) throws RecordingException {
    List<Place> rows = new ArrayList<>();
    int[] numbers = range.pages();
    for (int i = 0; i < numbers.length; i++) {
      int from = i == 0 ? range.first() : 0;
      int to = i == numbers.length - 1 ? range.end() : Integer.MAX_VALUE;
      SqliteTable.rows(pages, damages, numbers[i], from, to,
          (page, index, row) -> rows.add(new Place(row, columns.read(row, pages.mostBytes()))));
    }
    return rows;
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    throw new RecordingException(file.path(), attachment.offset(), "databases of rosbag2 have no attachments");
  }
}
