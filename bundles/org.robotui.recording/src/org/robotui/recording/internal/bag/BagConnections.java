package org.robotui.recording.internal.bag;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** The connections of a bag as channels, with the words that MCAP has for what comes from ROS 1. */
final class BagConnections {
  /** What is kept of a sender, under the same names in both. */
  static final List<String> KEPT = List.of("md5sum", "callerid", "latching");

  private final Map<Integer, RecordedChannel> channels;
  private boolean complete;

  BagConnections(Map<Integer, RecordedChannel> channels) {
    this.channels = channels;
  }

  void complete() {
    complete = true;
  }

  boolean knows(int connection) {
    return channels.containsKey(connection);
  }

  void add(BagFields header, PackedFields data) throws MalformedRecord {
    if (complete) {
      return;
    }
    int id = header.u32("conn");
    BagFields connection = new BagFields(data);
    RecordedSchema schema =
        new RecordedSchema(connection.needText("type"), "ros1msg", connection.bytes("message_definition"));
    Map<String, String> metadata = new LinkedHashMap<>();
    for (String name : KEPT) {
      connection.text(name).ifPresent(value -> metadata.put(name, value));
    }
    channels.putIfAbsent(id, new RecordedChannel(id, header.needText("topic"), "ros1", schema, metadata));
  }
}
