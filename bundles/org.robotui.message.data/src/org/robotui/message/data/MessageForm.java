package org.robotui.message.data;

import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;

/**
 * The Java value that holds the messages of a type. A robot interface makes of it what reads its own encoding.
 *
 * @param <M> the Java value of a message
 */
public sealed interface MessageForm<M> {

  /**
   * A record that is bound to the definition of its type.
   *
   * @param type the record
   * @param anyVersion whether other versions of the type than the shipped one are read as well, by the names of their
   * fields
   * @param <M> the record
   */
  record Bound<M extends Record>(Class<M> type, boolean anyVersion) implements MessageForm<M> {}

  /** Any message, read by the definition that the robot sends or that is known here. */
  record Dynamic() implements MessageForm<DynamicMessage> {}

  /** Any message whose fields have names, whatever defines them: also one of JSON or of Protocol Buffers. */
  record ByFields() implements MessageForm<DynamicRecord> {}
}
