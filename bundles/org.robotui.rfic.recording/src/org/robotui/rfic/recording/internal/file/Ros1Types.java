package org.robotui.rfic.recording.internal.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.robotui.message.DefinitionException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageSchema;
import org.robotui.recording.RecordedChannel;

/** Types of ROS 1 as recordings have them. */
public final class Ros1Types {
  private Ros1Types() {}

  /** The type of a channel of ROS 1; its sum is computed where it was not recorded. */
  public static MessageInfo of(RecordedChannel channel) throws IOException {
    String type = channel.schema().name();
    String definition = new String(channel.schema().definition(), StandardCharsets.UTF_8);
    String sum = channel.metadata().getOrDefault("md5sum", "");
    try {
      return sum.isEmpty() ? MessageSchema.parse(type, definition).info() : new MessageInfo(type, sum, definition);
    } catch (DefinitionException e) {
      throw new IOException(channel.topic() + ": the definition of " + type + " cannot be read: " + e.getMessage(), e);
    }
  }
}
