package org.robotui.roblets.roblet;

import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;

/** How a roblet speaks. Nothing of it blocks; whether anybody hears it is not told. Safe for all threads. */
public interface RobletSpeech {
  /**
   * Says something to the brain.
   *
   * @param message what
   * @throws IllegalArgumentException where it is larger than a datagram
   */
  void say(BodyElement message);

  /**
   * Says something to the brain.
   *
   * @param message what
   */
  default void say(Record message) {
    say(RecordMessage.ofRecord(message));
  }

  /**
   * Says something to a friend, without the brain.
   *
   * @param friend one of those that the form names
   * @param message what
   * @return false where the brain has not told yet where the friend is, or it is no friend
   */
  boolean tell(String friend, BodyElement message);
}
