package org.robotui.carmen.module;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.carmen.message.IpcRecord;

/** Takes the messages of one name, on the thread that reads a link. It must not block. */
@FunctionalInterface
public interface Handling {

  /**
   * A message has come.
   *
   * @param record its fields
   * @param body its bytes, a view of its own
   * @return the answer, where it is a question; empty otherwise
   */
  Optional<IpcAnswer> handle(IpcRecord record, ByteBuffer body);

  /**
   * A message has come that cannot be read.
   *
   * @param reason what is wrong with it
   */
  default void unreadable(String reason) {}
}
