package org.robotui.recording.internal.mcap;

import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** What stands in a chunk before its records. The length is that of the records after compression. */
record ChunkHead(long start, long end, int plainSize, int sum, String compression, long length) {

  /** Without the word for the compression. */
  static final int SIZE = 8 + 8 + 8 + 4 + 4 + 8;

  static ChunkHead of(PackedFields fields) throws MalformedRecord {
    long start = fields.i64("the start of a chunk");
    long end = fields.i64("the end of a chunk");
    long plain = fields.size("the size of a chunk");
    int sum = (int) fields.u32("the checksum of a chunk");
    String compression = fields.text("the compression of a chunk");
    long length = fields.size("the length of a chunk");
    if (plain > ChunkDecoder.MOST_BYTES || length > ChunkDecoder.MOST_BYTES) {
      throw new MalformedRecord("a chunk has " + Math.max(plain, length) + " bytes, more than the "
          + ChunkDecoder.MOST_BYTES + " that are read");
    }
    return new ChunkHead(start, end, (int) plain, sum, compression, length);
  }
}
