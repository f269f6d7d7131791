package org.robotui.recording.internal.mcap;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.zip.CRC32;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.ChunkSource;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.EntryTable;
import org.robotui.recording.internal.chunk.LoadedChunk;
import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.codec.Decoded;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Reads chunks of MCAP files, and runs of messages that lie in none. */
final class McapSource implements ChunkSource {

  private final FileBytes file;
  private final McapDefinitions definitions;
  private final DamageList damages;
  private final ChunkDecoder decoder = new ChunkDecoder();
  private volatile boolean decompresses;

  McapSource(FileBytes file, McapDefinitions definitions, DamageList damages) {
    this.file = file;
    this.definitions = definitions;
    this.damages = damages;
  }

  @Override
  public LoadedChunk load(ChunkRef ref) throws RecordingException {
    LoadedChunk chunk = load(ref.offset(), ref.length());
    damages.tellOtherTimes(ref, chunk);
    return chunk;
  }

  /** A chunk, or messages one after another, whatever begins there. */
  LoadedChunk load(long offset, long length) throws RecordingException {
    try {
      if (length > ChunkDecoder.MOST_BYTES + McapFormat.MOST_RECORD) {
        throw new MalformedRecord(
            length + " bytes are more than the " + ChunkDecoder.MOST_BYTES + " that are read at once");
      }
      byte[] bytes = file.read(offset, (int) length);
      return switch (bytes[0]) {
        case McapFormat.CHUNK -> chunk(offset, bytes);
        case McapFormat.MESSAGE, McapFormat.SCHEMA, McapFormat.CHANNEL -> records(offset, bytes, 0, bytes.length);
        default -> throw new MalformedRecord("there is no chunk where the index has one");
      };
    } catch (MalformedRecord e) {
      damages.add(offset, e.getMessage());
      return LoadedChunk.none();
    }
  }

  private LoadedChunk chunk(long offset, byte[] bytes) throws MalformedRecord {
    PackedFields fields = new PackedFields(bytes, 1, bytes.length);
    long content = fields.size("the length of a chunk");
    if (content < bytes.length - McapFormat.RECORD_HEAD) {
      throw new MalformedRecord("a chunk has " + content + " bytes, which is less than the index says");
    }
    ChunkHead head = ChunkHead.of(fields);
    if (!decoder.knows(head.compression())) {
      throw new MalformedRecord("a chunk is compressed by '" + head.compression() + "', which is not known here");
    }
    decompresses = !ChunkDecoder.isPlain(head.compression());
    int there = (int) Math.min(head.length(), fields.remaining());
    Decoded decoded = decoder.decode(head.compression(), bytes, fields.position(), there, head.plainSize());
    Optional<String> problem = there == head.length() ? decoded.problem()
        : Optional.of("the file ends in it, " + (head.length() - there) + " bytes early");
    if (problem.isPresent()) {
      damages.add(offset, "a chunk is not whole, so that only messages before the damage were read: " + problem.get());
    } else if (head.sum() != 0 && head.sum() != sum(decoded.bytes(), decoded.from(), decoded.length())) {
      throw new MalformedRecord("the checksum of a chunk is wrong, so that its messages were left out");
    }
    return records(offset, decoded.bytes(), decoded.from(), decoded.length());
  }

  private LoadedChunk records(long offset, byte[] bytes, int from, int length) {
    EntryTable entries = new EntryTable();
    PackedFields fields = new PackedFields(bytes, from, from + length);
    try {
      while (fields.hasMore()) {
        int code = fields.u8("the code of a record");
        long size = fields.size("the length of a record");
        if (code == McapFormat.MESSAGE && size >= McapFormat.MESSAGE_HEAD) {
          message(fields, size, entries, offset);
        } else {
          int begin = fields.skip(size, "a record");
          other(code, bytes, begin, (int) size, offset);
        }
      }
    } catch (MalformedRecord e) {
      damages.add(offset, "what follows in a chunk was left out: " + e.getMessage());
    }
    return entries.over(bytes);
  }

  /** Most records are messages: nothing is made of each but its entry. */
  private void message(PackedFields fields, long size, EntryTable entries, long offset) throws MalformedRecord {
    int channel = fields.u16("the channel of a message");
    long sequence = fields.u32("the number of a message");
    long logTime = fields.i64("the log time of a message");
    long publishTime = fields.i64("the publish time of a message");
    int length = (int) Math.min(Integer.MAX_VALUE, size - McapFormat.MESSAGE_HEAD);
    int from = fields.skip(length, "a message");
    if (definitions.knows(channel)) {
      entries.add(channel, logTime, publishTime, sequence, from, length);
    } else {
      damages.add(offset,
          "a message was left out: it is of channel " + channel + ", which the file does not describe");
    }
  }

  /** A record that is no message, or one that is too short. The format grows: others than these may be there. */
  private void other(int code, byte[] bytes, int from, int size, long offset) {
    try {
      switch (code) {
        case McapFormat.MESSAGE -> throw new MalformedRecord("a message has " + size + " bytes");
        case McapFormat.SCHEMA -> definitions.schema(new PackedFields(bytes, from, from + size));
        case McapFormat.CHANNEL -> definitions.channel(new PackedFields(bytes, from, from + size));
        default -> {
          // of no meaning here
        }
      }
    } catch (MalformedRecord e) {
      damages.add(offset, "a record in a chunk was left out: " + e.getMessage());
    }
  }

  @Override
  public boolean decompresses() {
    return decompresses;
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    long length = McapAttachments.length(file, attachment.offset());
    if (length > ChunkDecoder.MOST_BYTES) {
      throw new RecordingException(file.path(), attachment.offset(), "the attachment " + attachment.name() + " has "
          + length + " bytes, more than the " + ChunkDecoder.MOST_BYTES + " that are read");
    }
    byte[] bytes = file.read(attachment.offset() + McapFormat.RECORD_HEAD, (int) length);
    try {
      PackedFields fields = new PackedFields(bytes, 0, bytes.length);
      long size = McapAttachments.of(fields, attachment.offset()).size();
      int from = fields.skip(size, "the content");
      int end = fields.position();
      int expected = (int) fields.u32("the checksum");
      if (expected != 0 && expected != sum(bytes, 0, end)) {
        throw new MalformedRecord("its checksum is wrong");
      }
      return ByteBuffer.wrap(bytes, from, (int) size).slice().asReadOnlyBuffer();
    } catch (MalformedRecord e) {
      throw new RecordingException(file.path(), attachment.offset(),
          "the attachment " + attachment.name() + " cannot be read: " + e.getMessage());
    }
  }

  static int sum(byte[] bytes, int from, int length) {
    CRC32 crc = new CRC32();
    crc.update(bytes, from, length);
    return (int) crc.getValue();
  }
}
