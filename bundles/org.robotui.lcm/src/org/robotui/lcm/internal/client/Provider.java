package org.robotui.lcm.internal.client;

import java.io.IOException;

/** A way to LCM's messages, with a URL that was read. */
@FunctionalInterface
public interface Provider {

  /** Opens it; the error names what was to be reached and why it was not. */
  Link open() throws IOException;
}
