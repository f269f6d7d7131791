package org.robotui.recording.internal.mcap;

import java.util.HashMap;
import java.util.Map;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/**
 * The schemas and channels that a file describes. What comes first counts: the format wants repetitions to be the same.
 */
final class McapDefinitions {

  private final Map<Integer, RecordedSchema> schemas = new HashMap<>();
  private final Map<Integer, RecordedChannel> channels;
  private boolean complete;

  /** @param channels where they are to be kept */
  McapDefinitions(Map<Integer, RecordedChannel> channels) {
    this.channels = channels;
  }

  /** The file has no others: those inside of chunks are repetitions. */
  void complete() {
    complete = true;
  }

  boolean knows(int channel) {
    return channels.containsKey(channel);
  }

  void schema(PackedFields fields) throws MalformedRecord {
    if (complete) {
      return;
    }
    int id = fields.u16("the number of a schema");
    String name = fields.text("the name of a schema");
    String encoding = fields.text("the encoding of a schema");
    schemas.putIfAbsent(id, new RecordedSchema(name, encoding, fields.block("the definition of schema " + id)));
  }

  void channel(PackedFields fields) throws MalformedRecord {
    if (complete) {
      return;
    }
    int id = fields.u16("the number of a channel");
    int schema = fields.u16("the schema of a channel");
    String topic = fields.text("the topic of a channel");
    String encoding = fields.text("the encoding of a channel");
    Map<String, String> metadata = fields.texts("the metadata of channel " + id);
    if (schema != 0 && !schemas.containsKey(schema)) {
      throw new MalformedRecord("channel " + id + " has schema " + schema + ", which the file does not describe");
    }
    channels.putIfAbsent(id,
        new RecordedChannel(id, topic, encoding, schemas.getOrDefault(schema, RecordedSchema.NONE), metadata));
  }
}
