package org.robotui.message.recorded;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;

import org.robotui.message.MessageInfo;

/** Recorded messages as this library knows them. */
final class BagReader {

  /** One recorded message: topic, type as announced, time of recording, bytes. */
  record Recorded(String topic, MessageInfo info, long nanos, ByteBuffer bytes) {}

  private BagReader() {}

  static List<Recorded> read(Path bag) {
    return org.robotui.testkit.recorded.BagReader.read(bag).stream()
        .map(m -> new Recorded(m.topic(), new MessageInfo(m.type(), m.md5(), m.definition()), m.nanos(), m.bytes()))
        .toList();
  }
}
