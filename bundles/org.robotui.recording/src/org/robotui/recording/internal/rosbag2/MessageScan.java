package org.robotui.recording.internal.rosbag2;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.sqlite.SqliteRow;
import org.robotui.recording.internal.sqlite.SqliteTable;

/** Makes chunks of the rows of a table, by their order there. For one thread and one time. */
final class MessageScan implements SqliteTable.Rows {

  private static final long BYTES = 1 << 20;

  private final MessageColumns columns;
  private final FileIndex index;
  private final List<RowRange> ranges;
  private final long fileSize;
  private final ScanProgress progress;
  private final Map<Integer, Long> counts = new HashMap<>();
  private int[] pages = new int[16];
  private int pageCount;
  private int first;
  private int end;
  private long start = Long.MAX_VALUE;
  private long last = Long.MIN_VALUE;
  private long bytes;
  private long behind;

  MessageScan(MessageColumns columns, FileIndex index, List<RowRange> ranges, long fileSize, ScanProgress progress) {
    this.columns = columns;
    this.index = index;
    this.ranges = ranges;
    this.fileSize = fileSize;
    this.progress = progress;
  }

  @Override
  public void row(long page, int number, SqliteRow row) throws MalformedRecord {
    MessageColumns.Found found = columns.read(row, fileSize);
    if (row.length() > fileSize - behind - bytes) {
      throw new MalformedRecord("all rows together are longer than the file");
    }
    if (pageCount == 0) {
      first = number;
    }
    if (pageCount == 0 || pages[pageCount - 1] != page) {
      pages = pageCount == pages.length ? Arrays.copyOf(pages, pageCount * 2) : pages;
      pages[pageCount++] = (int) page;
    }
    end = number + 1;
    start = Math.min(start, found.time());
    last = Math.max(last, found.time());
    counts.merge(found.channel(), 1L, Long::sum);
    bytes += row.length();
    if (bytes >= BYTES) {
      close();
    }
  }

  /** Ends the chunk that has begun. */
  void close() {
    if (pageCount == 0) {
      return;
    }
    long count = counts.values().stream().mapToLong(Long::longValue).sum();
    index.chunks().add(ChunkRef.of(ranges.size(), 0, start, last, count,
        counts.keySet().stream().mapToInt(Integer::intValue).toArray()));
    counts.forEach((channel, more) -> index.counts().merge(channel, more, Long::sum));
    ranges.add(new RowRange(Arrays.copyOf(pages, pageCount), first, end));
    behind += bytes;
    progress.scanned(Math.min(behind, fileSize), fileSize);
    counts.clear();
    pageCount = 0;
    bytes = 0;
    start = Long.MAX_VALUE;
    last = Long.MIN_VALUE;
  }
}
