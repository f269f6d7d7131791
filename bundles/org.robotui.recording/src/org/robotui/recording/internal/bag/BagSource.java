package org.robotui.recording.internal.bag;

import java.nio.ByteBuffer;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.ChunkSource;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.EntryTable;
import org.robotui.recording.internal.chunk.LoadedChunk;
import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.codec.Decoded;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Reads chunks of bags. */
final class BagSource implements ChunkSource {

  private final FileBytes file;
  private final BagConnections connections;
  private final DamageList damages;
  private final ChunkDecoder decoder = new ChunkDecoder();
  private volatile boolean decompresses;

  BagSource(FileBytes file, BagConnections connections, DamageList damages) {
    this.file = file;
    this.connections = connections;
    this.damages = damages;
  }

  @Override
  public LoadedChunk load(ChunkRef ref) throws RecordingException {
    try {
      LoadedChunk chunk = load(ref.offset(), BagRecord.at(ref.offset(), file, ByteWindow.small(file)));
      damages.tellOtherTimes(ref, chunk);
      return chunk;
    } catch (MalformedRecord e) {
      damages.add(ref.offset(), "there is no chunk where the index has one: " + e.getMessage());
      return LoadedChunk.none();
    }
  }

  LoadedChunk load(long offset, BagRecord record) throws RecordingException, MalformedRecord {
    if (record.header().op() != BagFields.CHUNK) {
      throw new MalformedRecord("there is a record of the kind " + record.header().op());
    }
    String compression = record.header().needText("compression");
    long plain = record.header().u32("size") & 0xffff_ffffL;
    if (!decoder.knows(compression)) {
      throw new MalformedRecord("it is compressed by '" + compression + "', which is not known here");
    }
    if (Math.max(plain, record.length()) > ChunkDecoder.MOST_BYTES) {
      throw new MalformedRecord("it has " + Math.max(plain, record.length()) + " bytes, more than the "
          + ChunkDecoder.MOST_BYTES + " that are read");
    }
    decompresses = !ChunkDecoder.isPlain(compression);
    int there = (int) Math.min(record.length(), file.size() - record.data());
    Decoded decoded = decoder.decode(compression, file.read(record.data(), there), 0, there, (int) plain);
    if (there < record.length()) {
      damages.add(offset, "the file ends in a chunk, " + (record.length() - there) + " bytes early");
    } else {
      decoded.problem().ifPresent(problem -> damages.add(offset,
          "a chunk is not whole, so that only messages before the damage were read: " + problem));
    }
    return records(offset, decoded);
  }

  private LoadedChunk records(long offset, Decoded chunk) {
    byte[] bytes = chunk.bytes();
    EntryTable entries = new EntryTable();
    PackedFields fields = new PackedFields(bytes, chunk.from(), chunk.from() + chunk.length());
    BagMessageHead message = new BagMessageHead(bytes);
    try {
      while (fields.hasMore()) {
        int headerLength = (int) Math.min(Integer.MAX_VALUE, fields.u32("the header of a record"));
        int header = fields.skip(headerLength, "the header of a record");
        long size = fields.u32("the length of a record");
        int from = fields.skip(size, "the data of a record");
        if (!message.read(header, header + headerLength)) {
          other(new PackedFields(bytes, header, header + headerLength),
              new PackedFields(bytes, from, from + (int) size),
              offset);
        } else if (connections.knows(message.connection())) {
          entries.add(message.connection(), message.time(), message.time(), 0, from, (int) size);
        } else {
          damages.add(offset, "a message was left out: it is of connection " + message.connection()
              + ", which the bag does not describe");
        }
      }
    } catch (MalformedRecord e) {
      damages.add(offset, "what follows in a chunk was left out: " + e.getMessage());
    }
    return entries.over(bytes);
  }

  /** A record that is no message, or a damaged one. */
  private void other(PackedFields header, PackedFields data, long offset) {
    try {
      BagFields fields = new BagFields(header);
      if (fields.op() == BagFields.CONNECTION) {
        connections.add(fields, data);
      } else if (fields.op() == BagFields.MESSAGE) {
        throw new MalformedRecord("a message has no connection or no time");
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
    throw new RecordingException(file.path(), attachment.offset(), "bags have no attachments");
  }
}
