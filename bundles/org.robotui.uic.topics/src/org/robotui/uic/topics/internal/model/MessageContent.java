package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;

/**
 * What is in a message of a recording.
 *
 * @param message which
 * @param record its fields
 * @param bytes as they were recorded, of a long message the first ones; none where they are not known
 * @param size how many there are of them
 * @param changes against the message before it; none where there is none before
 */
public record MessageContent(TimedMessage message, DynamicRecord record, Optional<Bytes> bytes, int size,
    Optional<List<FieldChange>> changes) {
  /**
   * A field that differs.
   *
   * @param path where it is
   * @param before as it was in the message before; empty where that did not have it
   * @param now as it is; empty where the message does not have it
   */
  public record FieldChange(String path, String before, String now) {}
}
