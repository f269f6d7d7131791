package org.robotui.recording.internal.bag;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.chunk.ChunkRef;
import org.robotui.recording.internal.chunk.ChunkSource;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.EntryTable;
import org.robotui.recording.internal.chunk.LoadedChunk;
import org.robotui.recording.internal.codec.ChunkDecoder;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Reads pieces of bags of version 1.2. A message names its topic and type; its definition came before. */
final class OldBagSource implements ChunkSource {

  /** Longer records are left out. */
  static final int MOST_BYTES = ChunkDecoder.MOST_BYTES;

  private static final int DEFINITION = 0x01;
  private static final int MOST_CHANNELS = 10_000;

  private record Type(String name, String sum) {}

  private record Sender(String topic, Type type, String caller, String latching) {}

  private final FileBytes file;
  private final Map<Integer, RecordedChannel> channels;
  private final DamageList damages;
  private final Map<Type, byte[]> definitions = new HashMap<>();
  private final Map<Sender, Integer> numbers = new HashMap<>();
  private boolean complete;

  OldBagSource(FileBytes file, Map<Integer, RecordedChannel> channels, DamageList damages) {
    this.file = file;
    this.channels = channels;
    this.damages = damages;
  }

  /** All channels are known. */
  void complete() {
    complete = true;
    definitions.clear();
  }

  @Override
  public LoadedChunk load(ChunkRef ref) throws RecordingException {
    return load(ref.offset(), (int) ref.length());
  }

  LoadedChunk load(long offset, int length) throws RecordingException {
    byte[] bytes = file.read(offset, length);
    EntryTable entries = new EntryTable();
    PackedFields fields = new PackedFields(bytes, 0, length);
    long place = offset;
    try {
      while (fields.hasMore()) {
        place = offset + fields.position();
        PackedFields header = fields.part("the header of a record");
        long size = fields.u32("the length of a record");
        int from = fields.skip(size, "the data of a record");
        record(place, header, from, (int) size, entries);
      }
    } catch (MalformedRecord e) {
      damages.add(place, "the file has changed since it was opened: " + e.getMessage());
    }
    return entries.over(bytes);
  }

  private void record(long place, PackedFields header, int from, int size, EntryTable entries) {
    try {
      record(new BagFields(header), from, size, entries);
    } catch (MalformedRecord e) {
      damages.add(place, "a record was left out: " + e.getMessage());
    }
  }

  private void record(BagFields header, int from, int size, EntryTable entries) throws MalformedRecord {
    int op = header.op();
    if (op == DEFINITION && !complete) {
      definitions.putIfAbsent(new Type(header.needText("type"), header.needText("md5")), header.bytes("def"));
    } else if (op == BagFields.MESSAGE) {
      long time = (header.u32("sec") & 0xffff_ffffL) * 1_000_000_000L + (header.u32("nsec") & 0xffff_ffffL);
      entries.add(channel(header), time, time, 0, from, size);
    }
  }

  private int channel(BagFields header) throws MalformedRecord {
    Sender sender = new Sender(header.needText("topic"), new Type(header.needText("type"), header.needText("md5")),
        header.text("callerid").orElse(""), header.text("latching").orElse(""));
    Integer known = numbers.get(sender);
    if (known != null) {
      return known;
    }
    if (complete || numbers.size() >= MOST_CHANNELS) {
      throw new MalformedRecord("a message is of topic '" + sender.topic() + "', beyond the " + MOST_CHANNELS
          + " senders that are read");
    }
    int number = numbers.size();
    numbers.put(sender, number);
    channels.put(number, new RecordedChannel(number, sender.topic(), "ros1", schema(sender.type()), metadata(sender)));
    return number;
  }

  private RecordedSchema schema(Type type) throws MalformedRecord {
    byte[] definition = definitions.get(type);
    if (definition == null) {
      throw new MalformedRecord("the definition of " + type.name() + " does not come before its message");
    }
    return new RecordedSchema(type.name(), "ros1msg", definition);
  }

  private static Map<String, String> metadata(Sender sender) {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("md5sum", sender.type().sum());
    if (!sender.caller().isEmpty()) {
      metadata.put("callerid", sender.caller());
    }
    if (!sender.latching().isEmpty()) {
      metadata.put("latching", sender.latching());
    }
    return metadata;
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    throw new RecordingException(file.path(), attachment.offset(), "bags have no attachments");
  }
}
