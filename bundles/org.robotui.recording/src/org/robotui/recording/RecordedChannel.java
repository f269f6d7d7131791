package org.robotui.recording;

import java.util.Map;

/**
 * A series of messages of one type.
 *
 * @param id its number in this recording
 * @param topic the name that messages were sent by; several channels may have one
 * @param messageEncoding how the bytes of its messages are to be read: {@code ros1}, {@code cdr}, {@code protobuf},
 * {@code json}, or any other word; empty where nothing is known
 * @param schema the type of its messages
 * @param metadata what the recorder noted, such as who sent
 */
public record RecordedChannel(int id, String topic, String messageEncoding, RecordedSchema schema,
    Map<String, String> metadata) {

  /** As the components say; the metadata are copied. */
  public RecordedChannel {
    metadata = Map.copyOf(metadata);
  }

  /**
   * Whether the last message of its sender holds until the next one comes, and is given to those who listen later:
   * latched topics of ROS 1, and those of ROS 2 whose publishers are transient local.
   *
   * @return true where the recorder noted that
   */
  public boolean isLatched() {
    String qos = metadata.getOrDefault("offered_qos_profiles", "").replace(" ", "");
    return metadata.getOrDefault("latching", "").equals("1") || qos.contains("durability:1")
        || qos.contains("durability:transient_local");
  }
}
