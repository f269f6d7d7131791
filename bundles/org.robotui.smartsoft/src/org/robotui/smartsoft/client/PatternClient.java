package org.robotui.smartsoft.client;

import java.io.Closeable;
import java.util.Optional;

/** A connection to a service. It has one life: when it is over, another has to be made. Safe for all threads. */
public interface PatternClient extends Closeable {

  /**
   * Why the connection has ended.
   *
   * @return empty while it has not
   */
  Optional<String> over();

  /** Says goodbye without waiting, where several are closed together; {@link #close} waits for it. */
  void finish();

  /** Says goodbye and ends; bounded. */
  @Override
  void close();
}
