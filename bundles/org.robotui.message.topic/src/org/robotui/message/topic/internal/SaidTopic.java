package org.robotui.message.topic.internal;

import java.util.Map;
import org.robotui.message.MessageException;

/**
 * A topic on which single messages are said, which are made of fields by their names.
 *
 * @param topic says them
 * @param encoding makes them
 * @param <M> the Java value of a message
 */
record SaidTopic<M>(PatientTopic<M> topic, Encoding<M> encoding) {
  /**
   * Makes messages.
   *
   * @param <M> the Java value of a message
   */
  @FunctionalInterface
  interface Encoding<M> {
    M of(Map<String, Object> fields) throws MessageException;
  }

  /** What is not filled in as it should be is not said: one of the two exceptions names the field. */
  void say(Map<String, Object> fields) throws MessageException {
    topic.say(encoding.of(fields));
  }
}
