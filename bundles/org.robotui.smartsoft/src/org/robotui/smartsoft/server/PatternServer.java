package org.robotui.smartsoft.server;

import java.io.Closeable;
import org.robotui.smartsoft.naming.ServiceAddress;

/** One service, from its making until it is closed. Safe for all threads. */
public interface PatternServer extends Closeable {

  /**
   * Where it is.
   *
   * @return what is entered at a naming service
   */
  ServiceAddress address();

  /** Tells its clients that it ends, and ends. */
  @Override
  void close();
}
