package org.robotui.lcm.internal.client;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;

/** An open connection. */
public interface Link extends Closeable {

  /** What was reached, for a user to read. */
  String where();

  /** Receives until there is nothing more to come, and answers why, or until it breaks or is closed. */
  String receive() throws IOException;

  /** Sends a message. */
  void publish(byte[] channel, ByteBuffer data) throws IOException;

  /** Gives up what waits in vain. */
  default void tidy() {
    // where nothing waits
  }

  /** A subscription began. */
  default void subscribed(String channels) throws IOException {
    // whoever hears all of it needs not tell
  }

  /** A subscription ended. */
  default void unsubscribed(String channels) throws IOException {
    // whoever hears all of it needs not tell
  }
}
