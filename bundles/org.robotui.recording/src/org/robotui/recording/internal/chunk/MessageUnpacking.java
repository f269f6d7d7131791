package org.robotui.recording.internal.chunk;

import com.github.luben.zstd.Zstd;
import java.nio.ByteBuffer;
import java.util.Map;
import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.codec.Decoded;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedBytes;

/** Decompresses messages that were compressed one by one. */
public final class MessageUnpacking {

  private static final String ZSTD = "zstd";
  private static final int ROOM = 1 << 16;

  private final ChunkDecoder decoder = new ChunkDecoder();

  /** The same messages; what cannot be decompressed is told and left out. */
  LoadedChunk unpacked(LoadedChunk packed, Map<Integer, Integer> numbers, DamageList damages) {
    PackedBytes bytes = new PackedBytes(ROOM);
    EntryTable entries = new EntryTable();
    for (int i = 0; i < packed.size(); i++) {
      Integer channel = numbers.get(packed.channel(i));
      if (channel == null) {
        continue;
      }
      try {
        Decoded plain = plain(packed.data(i));
        int from = bytes.size();
        if (plain.length() > ChunkDecoder.MOST_BYTES - from) {
          throw new MalformedRecord("the messages around it are more than " + ChunkDecoder.MOST_BYTES + " bytes");
        }
        bytes.raw(plain.bytes(), plain.from(), plain.length());
        entries.add(channel, packed.logTime(i), packed.publishTime(i), packed.sequence(i), from,
            plain.length());
      } catch (MalformedRecord e) {
        damages.add(0, "a message of " + packed.logTime(i) + " ns was left out: " + e.getMessage());
      }
    }
    return entries.over(bytes.array());
  }

  private Decoded plain(ByteBuffer data) throws MalformedRecord {
    byte[] packed = new byte[data.remaining()];
    data.get(packed);
    long size = Zstd.getFrameContentSize(packed, 0, packed.length);
    if (size < 0 || size > ChunkDecoder.MOST_BYTES) {
      throw new MalformedRecord("it should be compressed by zstd, and is not, or says no size that is possible");
    }
    Decoded plain = decoder.decode(ZSTD, packed, 0, packed.length, (int) size);
    if (plain.problem().isPresent()) {
      throw new MalformedRecord(plain.problem().get());
    }
    return plain;
  }
}
